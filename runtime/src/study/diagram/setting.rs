//! What is asked of a diagram.

use crate::poincare::Section;
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
    /// Number of threads; all cores if nothing is said.
    pub threads: Option<usize>,
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
