//! Motions from a start: sampled, or where they meet a section.

mod crossings;
mod trajectory;

pub use trajectory::Trajectory;
