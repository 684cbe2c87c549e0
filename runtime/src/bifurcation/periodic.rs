//! What is told of a periodic orbit as a point of its branch.

use super::{Floquet, Kind};
use crate::continuation::Watched;

/// A point of a branch of periodic orbits; its regime is the cyclic order of the modes that it runs through.
pub trait PeriodicPoint: Watched {
    /// The period.
    fn period(&self) -> f64;

    /// Multipliers.
    fn floquet(&self) -> &Floquet;

    /// How many modes it runs through in a period.
    fn word_length(&self) -> usize;

    /// How much the second half of the orbit differs from the first one, relative to its extents: 0 where
    /// a doubled orbit meets the one from which it branches.
    fn asymmetry(&self) -> f64;

    /// How far it is from events that do not happen: positive, 0 where one begins to happen.
    fn near_misses(&self) -> Vec<Margin>;

    /// How far its events are from not happening: positive, 0 where one ceases to happen.
    fn close_calls(&self) -> Vec<Margin>;
}

/// A distance to a discontinuity-induced bifurcation, in units of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margin {
    /// Which bifurcation.
    pub kind: Kind,
    /// Number of the contact.
    pub contact: usize,
    /// The distance: a test function that vanishes there.
    pub value: f64,
}

impl Margin {
    /// The smallest distance of the same kind and contact among others.
    pub(super) fn smallest(&self, among: &[Self]) -> Option<f64> {
        let same = among
            .iter()
            .filter(|m| m.kind == self.kind && m.contact == self.contact);
        same.map(|m| m.value).min_by(f64::total_cmp)
    }
}
