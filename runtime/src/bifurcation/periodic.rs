//! What is told of a periodic orbit as a point of its branch.

use super::Floquet;
use crate::continuation::Watched;

/// A point of a branch of periodic orbits; its regime is the cyclic order of the modes that it runs through.
pub trait PeriodicPoint: Watched {
    /// The period.
    fn period(&self) -> f64;

    /// Multipliers.
    fn floquet(&self) -> &Floquet;

    /// How much the second half of the orbit differs from the first one, relative to its extents: 0 where
    /// a doubled orbit meets the one from which it branches.
    fn asymmetry(&self) -> f64;
}
