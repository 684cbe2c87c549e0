//! Equilibria: found, followed, and judged by their eigenvalues. Knows nothing of orbits.
//!
//! A mode of friction fixes a smooth field, f(y, r) = 0 in it is a zero problem, and the equilibrium is one of the
//! system as long as its contacts slide the way the mode says.

mod branch;
mod corner;
mod free;
mod krawczyk;
mod newton;
mod onset;
mod problem;
mod resting;
mod sizes;
mod special;
mod spectrum;
mod starts;
mod sticking;
mod sticking_equations;
mod unread;

pub use branch::{Branch, follow, settings};
pub use krawczyk::{Proof, Unproven, prove};
pub(crate) use newton::rests;
pub use newton::{Equilibrium, find, find_around, settle};
pub use onset::Onset;
pub use problem::EquilibriumProblem;
pub(crate) use sizes::{largest, sizes_at};
pub use special::EquilibriumPoint;
pub use spectrum::Spectrum;
pub use starts::starts;
pub use sticking::{StickingSet, sticking_sets};
