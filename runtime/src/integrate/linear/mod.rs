//! Motions of linear fields in closed form: exp(A t) by its Taylor series, with no error but rounding.
//!
//! A series needs no eigenvectors, so that equal and vanishing eigenvalues are nothing special to it. A step over which it
//! is short is made by maps that are computed once for each field; what is left of one, up to an event, by a series.

mod jump;
mod series;
mod stepper;

use super::Tolerance;
use crate::field::LinearField;
use jump::Jump;
use series::degree;
pub(crate) use stepper::LinearStepper;

/// Part of the motion that the dense output may be off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Blur {
    /// As little as the tolerance asks for: extrema are looked for on it.
    Fine,
    /// More: only guards are looked at, anew along a shorter step where they come as near to falling.
    Coarse,
}

/// Tolerances that a fine dense output need not, and may not, differ from.
const FINE: [f64; 2] = [1e-10, 1e-8];
/// How far a coarse one is off.
const COARSE: f64 = 1e-6;
/// Largest error of the dense output of (ρh)⁸/8!: 27/256 b⁴ with b = a (1 − a), a where it meets the series.
const FACTOR: f64 = 3.0e-4 / 40_320.0;

impl Blur {
    fn error(self, tolerance: Tolerance) -> f64 {
        match self {
            Self::Fine => tolerance.relative.clamp(FINE[0], FINE[1]),
            Self::Coarse => COARSE,
        }
    }
}

/// The flow of a linear field.
#[derive(Debug, Clone)]
pub(crate) struct LinearFlow<const N: usize> {
    field: LinearField<N>,
    /// The longest step: so long that the dense output is within the tolerance.
    longest: f64,
    /// How far that is off along the longest step, relative to the magnitude of the motion.
    error: f64,
    /// Number of terms of its series.
    degree: usize,
    /// The step of this length, where there is one.
    whole: Option<Box<Jump<N>>>,
}

impl<const N: usize> LinearFlow<N> {
    /// The flow of a field; `None` if it is faster than numbers tell.
    pub(crate) fn new(field: LinearField<N>, tolerance: Tolerance, blur: Blur) -> Option<Self> {
        let fastest = field.fastest();
        let error = blur.error(tolerance);
        let reach = (error / FACTOR).sqrt().sqrt().sqrt();
        let longest = reach / fastest;
        // A comparison that fails for NaN too.
        let regular = longest > 0.0;
        if !regular {
            return None;
        }
        let degree = degree(reach);
        let whole = longest.is_finite();
        let whole = whole.then(|| Box::new(Jump::new(&field, longest, degree)));
        Some(Self {
            field,
            longest,
            error,
            degree,
            whole,
        })
    }

    /// The step of this length, if it is the longest.
    fn whole(&self, length: f64) -> Option<&Jump<N>> {
        let whole = self.whole.as_deref();
        whole.filter(|jump| jump.length() == length)
    }

    /// How far the dense output of a step of this length is off, relative to the magnitude of the motion.
    fn error(&self, length: f64) -> f64 {
        self.error * (length / self.longest).powi(8)
    }

    /// The longest step.
    pub(crate) fn longest(&self) -> f64 {
        self.longest
    }
}
