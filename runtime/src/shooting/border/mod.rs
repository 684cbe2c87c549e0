//! Borders between two orders of events: discontinuity-induced bifurcations as points of their own.
//!
//! At a border an event begins or ceases to happen. Whatever the side from which it is come to, the orbit there solves
//! equations that are smooth on both sides of it, and what its return maps are on both sides says where it continues.

mod around;
mod arrival;
mod between;
mod brief;
mod candidate;
mod centred;
mod change;
mod crossing;
mod doubling;
mod held;
mod hit;
mod image;
mod located;
mod mirror;
mod nears;
mod once;
mod passing;
mod problem;
mod rising;
mod round;
mod runs;
mod sheet;
mod sides;

pub use around::borders;
pub(super) use between::{between, name};
pub use candidate::{Border, Condition};
pub(super) use crossing::cross;
pub(crate) use doubling::doubles;
pub use problem::{BorderProblem, BorderShot};
pub use sheet::Sheet;
