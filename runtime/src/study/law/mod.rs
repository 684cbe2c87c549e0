//! Laws on their own: force against sliding speed, the loops of laws that remember, and those of presses.

mod characteristic;
mod hysteresis;
mod specimen;
mod strike;

pub(in crate::study) use characteristic::Laws;
pub use characteristic::{Acting, Characteristic};
pub use hysteresis::Hysteresis;
pub use specimen::{Shown, Specimen};
pub use strike::Strike;
