//! Symmetries of orbits: which an orbit has, and where a branch of orbits that have one meets orbits that do not.

mod involution;
mod kept;
mod lost;
mod turns;

pub(super) use involution::Symmetry;
pub(super) use kept::SURE;
pub(super) use lost::{lost_between, refine};
