//! Brute-force diagrams: for many values of a design variable, let the motion settle and note where it
//! meets a section.
//!
//! A sweep begins each value where the one before ended, so that it stays with its attractor as long
//! as there is one: it is sequential by nature. Sweeps up and down run side by side, and values that
//! start afresh run on all cores; nothing depends on how many there are.

mod draw;
mod kind;
mod known;
mod record;
mod setting;
mod slice;
mod sweep;
mod watched;

pub use kind::Motion;
pub use known::Known;
pub use record::{DiagramRecord, Seen, SweepRecord, Watcher};
pub use setting::{Diagram, Sweep};
pub use slice::Slice;
