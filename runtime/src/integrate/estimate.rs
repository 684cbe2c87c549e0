//! What a step of DOP853 tells about itself: its error, its stiffness, and a first guess of its length.

use super::IntegrationError;
use super::carried::Carried;
use super::control::{EDGE_OF_STABILITY, combined};
use super::dop853::{ERROR_3, ERROR_5, Weights};
use super::stepper::{Stepper, weighted};
use crate::field::Field;

/// A step that turns the tangents by less has the derivatives that its states have.
const TURNED: f64 = 0.5;
/// Tolerance of the tangents, relative to themselves, over that of the states.
const LOOSER: f64 = 1e4;

impl<F: Field<N>, V: Carried<N>, const N: usize> Stepper<'_, F, V, N> {
    /// Local error of the step over what is tolerated, combined from orders 5 and 3 as Hairer does.
    pub(super) fn error(&self) -> f64 {
        let (from, end) = (self.from.state(), self.end.state());
        let fifth = self.state_sum(ERROR_5);
        let third = self.state_sum(ERROR_3);
        let tolerance = &self.settings.tolerance;
        let before = self.field.scale(from, tolerance);
        let after = self.field.scale(end, tolerance);
        let (mut sum_5, mut sum_3) = (0.0, 0.0);
        for i in 0..N {
            let scale = before[i].max(after[i]);
            sum_5 += (fifth[i] / scale).powi(2);
            sum_3 += (third[i] / scale).powi(2);
        }
        let states = self.length * combined(sum_5, sum_3, N);
        states.max(self.tangents_error(&before))
    }

    /// The same of the tangents, where a step turns them so far that they may be off: a motion that keeps still in a fast
    /// direction says nothing of what a disturbance would do there.
    fn tangents_error(&self, sizes: &[f64; N]) -> f64 {
        if !(self.from).turns(&self.slopes[0], self.length, TURNED, sizes) {
            return 0.0;
        }
        let sum = |weights: Weights| weighted(weights, &self.slopes);
        let off = self.from.strays(&sum(ERROR_5), &sum(ERROR_3), sizes);
        let tolerance = &self.settings.tolerance;
        self.length * off / (LOOSER * (tolerance.absolute + tolerance.relative))
    }

    #[inline(always)]
    fn state_sum(&self, weights: Weights) -> [f64; N] {
        let mut sum = [0.0; N];
        for &(j, weight) in weights {
            sum.add(weight, self.slopes[j].state());
        }
        sum
    }

    /// The proposed length, or Hairer's guess from the field and its change along a small Euler step.
    pub(super) fn first_length(&mut self) -> f64 {
        if let Some(length) = self.control.proposal {
            return length;
        }
        let (y, f) = (*self.from.state(), *self.slopes[0].state());
        let scale = self.field.scale(&y, &self.settings.tolerance);
        let norm = |v: &[f64; N]| -> f64 {
            let scaled = v.iter().zip(&scale).map(|(v, scale)| v / scale);
            (scaled.map(|s| s * s).sum::<f64>() / N as f64).sqrt()
        };
        let (size, slope) = (norm(&y), norm(&f));
        let euler = self.control.euler_length(size, slope);
        let mut look = y;
        look.add(euler, &f);
        let mut change = self.slope_at(&look);
        change.add(-1.0, &f);
        let bend = norm(&change) / euler;
        self.control.guess(euler, slope, bend)
    }

    /// Hairer's test: h times the dominant eigenvalue, estimated from the last two stages.
    pub(super) fn judge_stiffness(&mut self) -> Result<(), IntegrationError> {
        let (mut slopes, mut looks) = (0.0, 0.0);
        for i in 0..N {
            let slope = self.slopes[12].state()[i] - self.slopes[11].state()[i];
            slopes += slope * slope;
            looks += (self.end.state()[i] - self.last_look[i]).powi(2);
        }
        let edge = EDGE_OF_STABILITY / self.length;
        let at_edge = looks > 0.0 && slopes > edge * edge * looks && slopes.is_finite();
        if !self.control.is_stiff(at_edge, self.settings.stiff_steps) {
            return Ok(());
        }
        let spent = self.work.steps + self.work.rejected;
        let left = self.settings.steps.saturating_sub(spent);
        let needed = (self.until - self.time) / self.length;
        if self.settings.persists && needed <= left as f64 {
            return Ok(());
        }
        Err(IntegrationError::Stiff {
            time: self.time,
            step: self.length,
            needed,
            left,
        })
    }
}
