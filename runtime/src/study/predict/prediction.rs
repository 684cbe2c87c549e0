//! What is predicted of a copy.

use serde::{Deserialize, Serialize};

use crate::field::Smoothing;

/// The errors that a smoothing would make, relative and signed: copy/exact − 1.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Prediction {
    /// The smoothing.
    pub smoothing: Smoothing,
    /// Error of the frequency.
    pub frequency: f64,
    /// The same by the leading term of each release alone; `None` where it has no closed form.
    pub leading: Option<f64>,
    /// Error of the largest magnitude of each state; `None` where that is reached at a corner, or while a contact sticks.
    pub max_abs: Vec<Option<f64>>,
    /// Per state, whether the leading term of each release alone says something else of that: what is left of contributions
    /// that cancel is no better known than they are.
    pub cancelling: Vec<bool>,
    /// Shift of the start of the orbit, orthogonal to the field there; of one that runs on under a drive, at its phase.
    pub start: Vec<f64>,
    /// The releases of one period.
    pub releases: Vec<ReleaseLoss>,
    /// Why the prediction is not to be trusted; empty in the asymptotic range.
    pub doubts: Vec<String>,
}

impl Prediction {
    /// Whether the error of the largest magnitude of this state is not to be trusted.
    #[must_use]
    pub fn doubts_peak(&self, state: usize) -> bool {
        !self.doubts.is_empty() || self.cancelling.get(state).copied().unwrap_or(false)
    }
}

/// What one release costs the copy (7.1).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ReleaseLoss {
    /// Number of the contact.
    pub contact: usize,
    /// When, from the start of the orbit.
    pub time: f64,
    /// A = G |λ̇|.
    pub acceleration: f64,
    /// Effective G.
    pub compliance: f64,
    /// Δw; 0 for bumps.
    pub offset: f64,
    /// Delay of the release; 0 for sign types.
    pub delay: f64,
    /// The time that the layer takes.
    pub layer: f64,
    /// The shorter of the stick before it and the slip after it.
    pub room: f64,
}
