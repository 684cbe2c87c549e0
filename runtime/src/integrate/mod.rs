//! Integrators: static in the number of states, no heap in a step, exact derivatives of the discrete step.

mod bernstein;
mod carried;
mod control;
mod dense;
mod dop853;
mod estimate;
pub mod event;
pub mod explicit;
mod stepper;

pub use carried::{Carried, Motion};
pub use dense::Dense;

/// What a local error is measured against.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// Relative to the magnitude of each component.
    pub relative: f64,
    /// Absolute, in the units of each component.
    pub absolute: f64,
}

impl Tolerance {
    /// The error tolerated in a component that goes from `a` to `b`.
    #[must_use]
    pub fn scale(&self, a: f64, b: f64) -> f64 {
        self.absolute + self.relative * a.abs().max(b.abs())
    }
}

/// Why an integration stopped before its end.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum IntegrationError {
    /// The step size fell below what the time can resolve.
    #[error("step size {step:e} underflows at t = {time}, state {state:?}")]
    StepTooSmall {
        /// Time reached.
        time: f64,
        /// Step size that failed.
        step: f64,
        /// State reached.
        state: Vec<f64>,
    },
    /// The right-hand side gave NaN or infinity.
    #[error("the right-hand side is not finite at t = {time}, state {state:?}")]
    NotFinite {
        /// Time reached.
        time: f64,
        /// State reached.
        state: Vec<f64>,
    },
    /// More steps than allowed.
    #[error("{steps} steps were not enough: reached t = {time}, state {state:?}")]
    TooManySteps {
        /// Steps taken.
        steps: u64,
        /// Time reached.
        time: f64,
        /// State reached.
        state: Vec<f64>,
    },
    /// An explicit method met a stiff stretch.
    #[error("the problem is stiff at t = {time}")]
    Stiff {
        /// Time reached.
        time: f64,
    },
}
