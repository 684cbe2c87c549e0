//! The choice of the next step length from the errors of the last steps.

/// Exponents of a proportional-integral controller for an error of order 8.
const INTEGRAL: f64 = 0.04;
const PROPORTIONAL: f64 = 1.0 / 8.0 - 0.2 * INTEGRAL;

const SAFETY: f64 = 0.9;
const MOST_SHRINK: f64 = 0.2;
const MOST_GROWTH: f64 = 6.0;

/// h |λ| at which DOP853 loses stability.
pub(super) const EDGE_OF_STABILITY: f64 = 6.1;

/// A proportional-integral controller of step lengths, with a memory for stiffness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Control {
    /// What to try next, once known.
    pub(super) proposal: Option<f64>,
    span: f64,
    /// Logarithm of the last accepted error.
    last_error: f64,
    /// Length of the last accepted step; NaN before the first.
    last_length: f64,
    rejected: bool,
    stiff: u32,
    not_stiff: u32,
}

impl Control {
    pub(super) fn new(span: f64) -> Self {
        Self {
            proposal: None,
            span,
            last_error: 1e-4_f64.ln(),
            last_length: f64::NAN,
            rejected: false,
            stiff: 0,
            not_stiff: 0,
        }
    }

    /// Length of the Euler step that probes how fast the field bends.
    pub(super) fn euler_length(&self, size: f64, slope: f64) -> f64 {
        let length = 0.01 * size / slope;
        if length.is_finite() && length > 0.0 {
            length.min(self.span)
        } else {
            1e-3 * self.span
        }
    }

    /// Hairer's first length.
    pub(super) fn guess(&self, euler: f64, slope: f64, bend: f64) -> f64 {
        let steepest = slope.max(bend);
        let length = (0.01 / steepest).powf(1.0 / 8.0);
        if length.is_finite() {
            length.min(100.0 * euler)
        } else {
            euler
        }
    }

    /// Proposes the length after an accepted step.
    ///
    /// Where errors grow from step to step, as before a landing, Gustafsson's prediction takes the trend
    /// into account; the integral part alone would be rejected every other time.
    pub(super) fn accept(&mut self, length: f64, error: f64) {
        let error = error.max(1e-14).ln();
        let steady = INTEGRAL * self.last_error - PROPORTIONAL * error;
        let trend = (length / self.last_length).ln() + (self.last_error - 2.0 * error) / 8.0;
        let growth = SAFETY * if trend < steady { trend } else { steady }.exp();
        let most = if self.rejected { 1.0 } else { MOST_GROWTH };
        self.proposal = Some(length * growth.clamp(MOST_SHRINK, most));
        self.last_error = error.max(1e-4_f64.ln());
        self.last_length = length;
        self.rejected = false;
    }

    /// The length to try after a rejected step.
    pub(super) fn reject(&mut self, length: f64, error: f64) -> f64 {
        self.rejected = true;
        let shrink = if error.is_finite() {
            (SAFETY / error.powf(PROPORTIONAL)).clamp(MOST_SHRINK, SAFETY)
        } else {
            MOST_SHRINK
        };
        length * shrink
    }

    /// Whether time can no longer resolve the length.
    pub(super) fn exhausted(&self, length: f64, time: f64) -> bool {
        length <= 4.0 * f64::EPSILON * time.abs().max(1e-6 * self.span)
    }

    /// Whether `limit` steps, with no six others together between them, were at the edge of stability.
    pub(super) fn is_stiff(&mut self, at_edge: bool, limit: u32) -> bool {
        if at_edge {
            self.stiff += 1;
            self.not_stiff = 0;
        } else {
            self.not_stiff += 1;
            if self.not_stiff == 6 {
                self.stiff = 0;
            }
        }
        self.stiff >= limit
    }
}

/// The errors of orders 5 and 3 in one number, from the sums of their squares over so many terms.
pub(super) fn combined(sum_5: f64, sum_3: f64, terms: usize) -> f64 {
    ratio(sum_5, ((sum_5 + 0.01 * sum_3) * terms as f64).sqrt())
}

/// a/b, and 0 where both vanish.
pub(super) fn ratio(a: f64, b: f64) -> f64 {
    if a == 0.0 { 0.0 } else { a / b }
}
