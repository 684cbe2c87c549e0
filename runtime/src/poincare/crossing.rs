//! Points of a motion on a section.

use serde::Serialize;

/// A point where a motion crosses a section.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Crossing {
    /// When, from the beginning of the motion.
    pub time: f64,
    /// Whether the function that vanishes there grows.
    pub rising: bool,
    /// Where; the phase of a drive between 0 and 2π.
    pub state: Vec<f64>,
}
