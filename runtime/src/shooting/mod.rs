//! Periodic orbits by shooting: thesis section 2.2.

mod anchor;
mod border;
mod branch;
mod certificate;
mod converge;
mod error;
mod guess;
mod hopf;
mod neutral;
mod orbit;
mod phase;
mod pin;
mod problem;
mod same;
mod search;
mod shot;
mod stay;
mod switch;
mod symmetry;
mod watched;

pub use anchor::anchored;
pub(crate) use anchor::problem;
pub use border::{Border, BorderProblem, BorderShot, Condition, Sheet, borders};
pub use branch::{OrbitBranch, Orbits};
pub use certificate::{Certificate, Constants, Uncertified, certify};
pub use converge::converge;
pub use error::OrbitError;
pub use guess::{Guess, Settled, settle};
pub(crate) use orbit::Solution;
pub use orbit::{Heading, Orbit};
pub use phase::Phase;
pub use pin::Pin;
pub use problem::OrbitProblem;
pub use search::{Search, closest, settled};
pub use shot::Shot;
pub use switch::SwitchError;
