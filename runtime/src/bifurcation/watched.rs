//! What detection needs to know of a branch: its points, and what lies between two of them.

use super::{Floquet, Kind};

/// A point of a branch of periodic orbits.
pub trait Watched: Clone {
    /// The design variable.
    fn r(&self) -> f64;

    /// The period.
    fn period(&self) -> f64;

    /// r-component of the unit tangent of the branch.
    fn slope(&self) -> f64;

    /// Multipliers.
    fn floquet(&self) -> &Floquet;

    /// Whether both orbits run through the same modes in the same cyclic order.
    fn same_word(&self, other: &Self) -> bool;

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

/// The branch between two neighbouring points.
pub trait Path {
    /// Its points.
    type Point: Watched;
    /// Why one could not be found.
    type Error: std::fmt::Display;

    /// The point at a share of the way, 0 < share < 1.
    ///
    /// # Errors
    /// No point could be found there.
    fn at(&mut self, share: f64) -> Result<Self::Point, Self::Error>;
}

/// A point and its place on a path.
#[derive(Debug, Clone)]
pub(super) struct Spot<P> {
    pub(super) share: f64,
    pub(super) point: P,
}
