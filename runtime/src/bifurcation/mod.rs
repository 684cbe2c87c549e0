//! Stability of periodic motions, and where it changes.

mod floquet;

pub use floquet::{Floquet, Stability, floquet};
