//! What is reported of a diagram.

use std::ops::ControlFlow;

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

/// A value of a diagram as it is found.
#[derive(Debug, Clone, Copy)]
pub struct Seen<'a> {
    /// The sweep to which it belongs.
    pub sweep: &'static str,
    /// What is seen there.
    pub slice: &'a Slice,
    /// Whether it was known before.
    pub known: bool,
    /// The share of all values that are there.
    pub share: f64,
}

/// Told of each value of a diagram, from any thread; a break ends the diagram there.
pub type Watcher<'a> = &'a (dyn Fn(Seen<'_>) -> ControlFlow<()> + Sync);

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
