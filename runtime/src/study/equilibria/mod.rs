//! Equilibria of a system: of its exact friction, of its copies, and what the one says of the other.

mod counterpart;
mod found;
mod modes;
mod others;
mod record;
mod special;

pub(in crate::study) use modes::{sliding_mode, sliding_modes, spelt};
pub use record::{EquilibriaRecord, EquilibriumRecord, Extent, SpecialEquilibrium};
