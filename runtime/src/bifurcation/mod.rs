//! Stability of periodic motions, and where it changes.
//!
//! Knows multipliers, margins and a path between two points; nothing of how orbits are found.

mod detect;
mod ending;
mod exponents;
mod floquet;
mod kind;
mod locate;
pub mod test_function;
mod watched;
mod word_change;

pub use detect::{Findings, Located, Unexplained, detect};
pub use ending::explain;
pub use floquet::{Floquet, Stability, floquet};
pub use kind::Kind;
pub use locate::reach;
pub use watched::{Margin, Path, Watched};
