//! Answers as figures.

mod branch;
mod curve;
mod diagram;
mod motion;

use super::text::label;
use crate::model::Unit;
use crate::report::Axis;

pub(super) use branch::{branch, equilibria};
pub(super) use curve::curve;
pub(super) use diagram::diagram;
pub(super) use motion::motion;

/// The axis of a quantity, with its unit if it has one.
fn axis(name: &str, unit: Option<Unit>) -> Axis {
    Axis::new(&label(name, unit))
}
