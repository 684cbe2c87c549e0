//! Integrators: static in the number of states, no heap in a step, exact derivatives of the discrete step.

mod bernstein;
mod carried;
mod collocation;
mod control;
mod corner;
mod dense;
mod dop853;
mod estimate;
pub mod event;
pub mod explicit;
mod gauss;
pub(crate) mod linear;
mod look;
mod lu;
mod radau;
mod stepper;
mod tableau;
mod tracked;

pub use carried::{Carried, Motion};
pub use collocation::Collocation;
pub use dense::Dense;
pub(crate) use gauss::gauss;
pub use look::Look;
pub use radau::{Accepted, Radau};
pub use tableau::{RADAU_3, RADAU_5, Tableau};
pub(crate) use tracked::Tracked;

use crate::model::{ModelInfo, Values, brief};

/// What a local error is measured against.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// Relative to the magnitude of each component.
    pub relative: f64,
    /// Absolute, in the units of each component.
    pub absolute: f64,
}

impl Tolerance {
    /// The local tolerance that gives periods and extrema a relative error of about `accuracy`.
    ///
    /// The error estimates are of a lower order than the methods, so that the error itself falls
    /// faster than the tolerance; calibrated on the reference systems.
    #[must_use]
    pub fn for_accuracy(accuracy: f64) -> Self {
        Self::both(accuracy.powf(0.8).clamp(1e-11, 3e-7))
    }

    /// The same tolerance of quantities and of their usual magnitudes.
    #[must_use]
    pub const fn both(local: f64) -> Self {
        Self {
            relative: local,
            absolute: local,
        }
    }

    /// The tolerance at which the explicit method is about as accurate as the implicit one at this.
    #[must_use]
    pub fn explicit(self) -> Self {
        let local = |tolerance: f64| (0.3 * tolerance.powf(1.25)).max(1e-14);
        Self {
            relative: local(self.relative),
            absolute: local(self.absolute),
        }
    }

    /// The error tolerated in a quantity of this magnitude.
    #[must_use]
    pub fn of(&self, magnitude: f64) -> f64 {
        (self.absolute + self.relative) * magnitude.abs()
    }

    /// A tolerance `factor` times as large.
    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        Self {
            relative: self.relative * factor,
            absolute: self.absolute * factor,
        }
    }
}

/// Why an integration stopped before its end.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum IntegrationError {
    /// The step size fell below what the time can resolve.
    #[error("the step size underflows at t = {}, where {state}: {step:.1e}", brief(*.time))]
    StepTooSmall {
        /// Time reached.
        time: f64,
        /// Step size that failed.
        step: f64,
        /// State reached.
        state: Values,
    },
    /// The right-hand side gave NaN or infinity.
    #[error("the right-hand side is not finite at t = {}, where {state}", brief(*.time))]
    NotFinite {
        /// Time reached.
        time: f64,
        /// State reached.
        state: Values,
    },
    /// More steps than allowed.
    #[error("{steps} steps were not enough: reached t = {}, where {state}", brief(*.time))]
    TooManySteps {
        /// Steps taken.
        steps: u64,
        /// Time reached.
        time: f64,
        /// State reached.
        state: Values,
    },
    /// An explicit method met a stiff stretch.
    #[error(
        "the problem is stiff at t = {}: what decays fastest allows steps of {step:.1e} only, of which the rest of the time needs \
         {needed:.1e}, and {left} are left", brief(*.time)
    )]
    Stiff {
        /// Time reached.
        time: f64,
        /// The longest step that is stable.
        step: f64,
        /// Steps of this length in the rest of the span.
        needed: f64,
        /// Steps that were still allowed.
        left: u64,
    },
}

impl IntegrationError {
    /// The same with the states by their names.
    #[must_use]
    pub fn named(mut self, model: &'static ModelInfo) -> Self {
        match &mut self {
            Self::StepTooSmall { state, .. }
            | Self::NotFinite { state, .. }
            | Self::TooManySteps { state, .. } => *state = state.clone().named(model),
            Self::Stiff { .. } => {}
        }
        self
    }

    /// The same of a motion that began so much earlier.
    #[must_use]
    pub fn later(mut self, by: f64) -> Self {
        match &mut self {
            Self::StepTooSmall { time, .. }
            | Self::NotFinite { time, .. }
            | Self::TooManySteps { time, .. }
            | Self::Stiff { time, .. } => *time += by,
        }
        self
    }
}

/// How the end of a step depends on its start, on the design variable and on its length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Propagator<const N: usize> {
    /// ∂y₁/∂y₀.
    pub state: [[f64; N]; N],
    /// ∂y₁/∂r.
    pub design: [f64; N],
    /// ∂y₁/∂h.
    pub time: [f64; N],
    /// ∫ tr J dt.
    pub trace: f64,
}

impl<const N: usize> Propagator<N> {
    /// A step of no length.
    pub const IDENTITY: Self = {
        let mut state = [[0.0; N]; N];
        let mut i = 0;
        while i < N {
            state[i][i] = 1.0;
            i += 1;
        }
        Self {
            state,
            design: [0.0; N],
            time: [0.0; N],
            trace: 0.0,
        }
    };

    /// This step after an earlier one.
    #[must_use]
    pub(crate) fn after(&self, earlier: &Self) -> Self {
        let motion = Motion {
            state: [0.0; N],
            tangent: earlier.state,
            design: earlier.design,
            trace: earlier.trace,
        };
        let motion = motion.through(self);
        Self {
            state: motion.tangent,
            design: motion.design,
            time: [0.0; N],
            trace: motion.trace,
        }
    }
}
