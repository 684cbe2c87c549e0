//! What is asked of a search.

use crate::motion::Modes;

/// What to look for.
#[derive(Debug, Clone, PartialEq)]
pub struct Search {
    /// Where to begin.
    pub start: Vec<f64>,
    /// The modes in which that was reached; empty where the state alone decides.
    pub modes: Modes,
    /// A guess of the period; then Newton begins at once.
    pub period: Option<f64>,
    /// Relative accuracy of period and extrema.
    pub accuracy: f64,
    /// Number of shooting segments.
    pub segments: usize,
}
