//! Stability of periodic motions, and where it changes.
//!
//! Knows multipliers, margins and the monitors made of them; nothing of how orbits are found or branches followed.

mod ending;
mod exponents;
mod floquet;
mod growth;
mod liouville;
mod monitors;
mod periodic;
mod stability;
pub mod test_function;
mod units;

pub use crate::continuation::Kind;
pub use ending::{explain, falls};
pub use floquet::{Floquet, floquet};
pub use growth::{Growth, Growths};
pub use monitors::monitors;
pub use periodic::PeriodicPoint;
pub use stability::Stability;
pub(crate) use units::Disturbances;
