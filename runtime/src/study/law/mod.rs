//! Friction laws on their own: force against sliding speed, and the loops of laws that remember.

mod characteristic;
mod hysteresis;
mod specimen;

pub(in crate::study) use characteristic::Laws;
pub use characteristic::{Acting, Characteristic};
pub use hysteresis::Hysteresis;
pub use specimen::{Shown, Specimen};
