//! Motions from a start: sampled, or where they meet a section.

mod crossings;
mod envelope;
mod extremes;
mod follow;
mod sized;
mod trajectory;

pub use envelope::Envelope;
pub use trajectory::{Limits, Trajectory};
