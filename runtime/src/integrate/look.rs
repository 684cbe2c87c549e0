//! A look inside a step.

use crate::field::Linear;

/// A state inside a step, with the field there.
#[derive(Debug, Clone, Copy)]
pub struct Look<const N: usize> {
    /// Fraction of the step.
    pub theta: f64,
    /// State there.
    pub state: [f64; N],
    /// Field there.
    pub linear: Linear<N>,
}

impl<const N: usize> Look<N> {
    /// The sign of fⱼ, or 0 where the rounding of the state decides it.
    #[must_use]
    pub fn sign(&self, j: usize) -> f64 {
        let slopes = &self.linear.jacobian[j];
        let noise: f64 = (0..N).map(|k| (slopes[k] * self.state[k]).abs()).sum();
        let slope = self.linear.f[j];
        if slope.abs() <= 16.0 * f64::EPSILON * noise {
            0.0
        } else {
            slope.signum()
        }
    }
}
