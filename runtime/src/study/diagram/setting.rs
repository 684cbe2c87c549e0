//! What is asked of a diagram.

use crate::poincare::Section;
use crate::study::work::Rows;
use crate::words::words;

/// What is to be drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Diagram {
    /// Where points are taken.
    pub section: Section,
    /// How the values follow each other.
    pub sweep: Sweep,
    /// How many values, evenly spaced, both ends among them.
    pub values: usize,
    /// Crossings of the section that are left out while the motion settles.
    pub settle: usize,
    /// Crossings that are noted.
    pub points: usize,
    /// Laps over which the largest Lyapunov exponent is averaged, if it is wanted.
    pub lyapunov: Option<usize>,
}

words! {
    /// How the values of a diagram follow each other.
    pub enum Sweep {
        /// From the smallest to the largest, each from the end of the one before.
        Up = "up",
        /// From the largest to the smallest, each from the end of the one before.
        Down = "down",
        /// Up, and down: where they differ, there are two attractors.
        Both = "both",
        /// Each value from the start of the case.
        Fresh = "fresh",
    }
}

impl Diagram {
    /// Its items: each value of a sweep begins where the one before ended, so that a sweep is a row; values that start
    /// afresh build on none.
    #[must_use]
    pub fn rows(&self) -> Rows {
        let (sweeps, values) = (self.sweeps().len(), self.values.max(2));
        match self.sweep {
            Sweep::Fresh => Rows::of(values),
            _ => Rows {
                count: sweeps,
                length: values,
            },
        }
    }

    /// The sweep to which an item belongs: `Up`, `Down` or `Fresh`.
    #[must_use]
    pub fn sweep_of(&self, item: usize) -> Sweep {
        let sweeps = self.sweeps();
        sweeps[(item / self.values.max(2)).min(sweeps.len() - 1)]
    }

    /// The sweeps, one after the other.
    pub(super) const fn sweeps(&self) -> &'static [Sweep] {
        match self.sweep {
            Sweep::Up => &[Sweep::Up],
            Sweep::Down => &[Sweep::Down],
            Sweep::Both => &[Sweep::Up, Sweep::Down],
            Sweep::Fresh => &[Sweep::Fresh],
        }
    }
}
