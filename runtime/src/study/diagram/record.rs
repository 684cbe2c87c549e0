//! What is reported of a diagram.

use super::setting::Diagram;
use super::slice::Slice;
use crate::field::Work;
use crate::study::question::Along;

/// A diagram as it is reported, whatever model it belongs to.
#[derive(Debug, Clone, PartialEq)]
pub struct DiagramRecord {
    /// The design variable and its range.
    pub along: Along,
    /// What was asked for.
    pub diagram: Diagram,
    /// One or two sweeps.
    pub sweeps: Vec<SweepRecord>,
    /// How many values are not there, because it was interrupted.
    pub missing: usize,
}

/// One sweep over all values.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepRecord {
    /// `up`, `down` or `fresh`.
    pub name: &'static str,
    /// The values in the order of the sweep.
    pub slices: Vec<Slice>,
}

impl DiagramRecord {
    /// Work of all values.
    #[must_use]
    pub fn work(&self) -> Work {
        let slices = self.sweeps.iter().flat_map(|sweep| &sweep.slices);
        slices.fold(Work::default(), |mut all, slice| {
            all += slice.work;
            all
        })
    }
}
