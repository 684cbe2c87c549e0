//! The library of dry friction laws.

mod coulomb;
mod stribeck;
mod weakening;

pub use coulomb::{Coulomb, CoulombStatic};
pub use stribeck::Stribeck;
pub use weakening::Weakening;
