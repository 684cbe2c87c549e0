//! Axes of quantities.

use super::text::{followed, label};
use crate::field::Design;
use crate::model::{ModelInfo, Unit};
use crate::report::Axis;
use crate::report::symbols::typeset;
use crate::study::Along;

/// The axis of a quantity, with its unit if it has one.
pub(super) fn axis(name: &str, unit: Option<Unit>) -> Axis {
    Axis::new(&label(&typeset(name), unit))
}

/// The axis of what a head of a table names.
pub(super) fn headed_axis(head: &str) -> Axis {
    let (name, unit) = head.split_once(" (").unwrap_or((head, ""));
    let gap = if unit.is_empty() { "" } else { " (" };
    Axis::new(&format!("{}{gap}{unit}", typeset(name)))
}

/// The axis of what is followed: a size of smoothing by its logarithm.
pub(super) fn along_axis(info: &ModelInfo, along: &Along) -> Axis {
    let axis = headed_axis(&followed(info, along));
    if along.design == Design::Smoothing {
        axis.logarithmic()
    } else {
        axis
    }
}
