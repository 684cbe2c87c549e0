//! Periodic orbits by shooting: thesis section 2.2.

mod branch;
mod guess;
mod orbit;
mod phase;
mod problem;
mod search;
mod watched;

pub use branch::{OrbitBranch, OrbitPath};
pub use guess::{Guess, Settled, settle};
pub use orbit::Orbit;
pub use phase::Phase;
pub use problem::{OrbitProblem, Shot};
pub(crate) use search::problem;
pub use search::{OrbitError, Search, anchored, closest, converge};
