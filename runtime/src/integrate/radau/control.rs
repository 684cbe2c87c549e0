//! The length of the next step, and the first guess of its stages.

use super::{GROW, NEWTON_ITERATIONS, Radau, SAFETY, SHRINK};
use crate::field::{Field, Linear};
use crate::scalar::mapped;

impl<F: Field<N>, const N: usize, const S: usize> Radau<'_, F, N, S> {
    /// Gustafsson's predictive controller, as in Hairer & Wanner II, section IV.8.
    pub(super) fn grow(&self, error: f64, step: f64, iterations: usize) -> f64 {
        let order = S as f64 + 1.0;
        let effort = SAFETY * (2 * NEWTON_ITERATIONS + 1) as f64
            / (2 * NEWTON_ITERATIONS + iterations) as f64;
        let error = error.max(1e-9);
        let mut factor = effort * error.powf(-1.0 / order);
        if let Some(before) = &self.before {
            let trend = step / before.step * (before.error / (error * error)).powf(1.0 / order);
            factor = factor.min(effort * trend);
        }
        step * factor.clamp(SHRINK, if self.rejected { 1.0 } else { GROW })
    }

    /// The polynomial of the step before, continued.
    pub(super) fn predict(&self, step: f64) -> [[f64; N]; S] {
        let nodes = &self.tableau.nodes;
        match &self.before {
            Some(before) => {
                let ratio = step / before.step;
                let end = before.collocation.at(1.0);
                crate::scalar::filled(|i| {
                    let value = before.collocation.at(1.0 + nodes[i] * ratio);
                    crate::scalar::filled(|j| value[j] - end[j])
                })
            }
            None => {
                crate::scalar::filled(|i| mapped(&self.start.f, |slope| step * nodes[i] * slope))
            }
        }
    }
}

/// The step to try where `rest` is left: never one that would leave a splinter.
pub(super) fn fitting(step: f64, rest: f64) -> f64 {
    if step >= rest {
        rest
    } else if 2.0 * step > rest {
        0.5 * rest
    } else {
        step
    }
}

/// A step small enough for the first error test to be meaningful.
pub(super) fn first_step<const N: usize>(
    linear: &Linear<N>,
    scale: &[f64; N],
    stages: usize,
) -> f64 {
    let rate = (0..N).fold(1e-300_f64, |rate, j| rate.max(linear.f[j].abs() / scale[j]));
    (rate.recip().powf(1.0 / stages as f64) * 1e-1).clamp(1e-14, 1.0)
}
