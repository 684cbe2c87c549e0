//! Stability of periodic motions, and where it changes.

mod exponents;
mod floquet;

pub use floquet::{Floquet, Stability, floquet};
