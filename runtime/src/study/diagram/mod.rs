//! Brute-force diagrams: for many values of a design variable, let the motion settle and note where it
//! meets a section.
//!
//! A sweep begins each value where the one before ended, so that it stays with its attractor as long
//! as there is one: that is part of the question, and a sweep is a row of items that build on each other. Sweeps up and
//! down run side by side, and values that start afresh run on all cores; nothing depends on how many there are.

mod draw;
mod kind;
mod record;
mod setting;
mod slice;
mod sweep;
mod usual;
mod watched;

pub use kind::Motion;
pub use record::{DiagramRecord, SweepRecord};
pub use setting::{Diagram, Sweep};
pub use slice::Slice;
