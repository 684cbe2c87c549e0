//! The local error of a step, from the embedded formula: Hairer & Wanner II, section IV.8.

use super::super::lu::Lu;
use super::layout::{Layout, kinematic, position};
use super::stages::Trial;
use super::{Radau, add};
use crate::field::Field;

impl<F: Field<N>, const N: usize, const S: usize> Radau<'_, F, N, S> {
    /// Estimated local error relative to what is tolerated.
    pub(super) fn error(&mut self, trial: &Trial<N, S>) -> f64 {
        let end = trial.end();
        let scale = self.scale(&end);
        let (start, arrival) = (self.start, trial.linear[S - 1]);
        let estimate = self.filtered(trial, &start.f, &start.jacobian);
        let size = |error: &[f64; N]| {
            (0..N).fold(0.0_f64, |largest, j| {
                let relative = error[j].abs() / scale[j];
                if relative > largest || relative.is_nan() {
                    relative
                } else {
                    largest
                }
            })
        };
        // A stiff start damps the estimate even of a step that jumps out of its layer; the end then is not stiff.
        let unstiff = size(&self.filtered(trial, &start.f, &arrival.jacobian));
        let first = size(&estimate).max(unstiff);
        if first <= 1.0 || !(self.rejected || self.before.is_none()) {
            return first;
        }
        self.work.evaluations += 1;
        let slope = self.field.f(&add(&self.state, &estimate));
        size(&self.filtered(trial, &slope, &start.jacobian))
            .max(unstiff)
            .min(first)
    }

    /// (I − γhJ)⁻¹ (γ h f + Σ eᵢ Zᵢ).
    fn filtered(
        &self,
        trial: &Trial<N, S>,
        slope: &[f64; N],
        jacobian: &[[f64; N]; N],
    ) -> [f64; N] {
        let (solved, shift) = (Layout::<F, N>::solved(), trial.step * self.tableau.gamma);
        let mut error: [f64; N] = crate::scalar::filled(|j| {
            let stages: f64 = (0..S)
                .map(|i| self.tableau.error[i] * trial.increments[i][j])
                .sum();
            shift * slope[j] + stages
        });
        let mut lu = Lu::<N, 1>::zero(solved.len());
        let mut right = [0.0; N];
        for (d, &row) in solved.iter().enumerate() {
            let slopes = &jacobian[row];
            right[d] = error[row];
            let out = lu.row(d);
            for (c, &column) in solved.iter().enumerate() {
                out[c] = f64::from(c == d) - shift * slopes[column];
            }
            for (eliminated, source) in kinematic::<F, N>() {
                out[position(solved, source)] -= shift * shift * slopes[eliminated];
                right[d] += shift * slopes[eliminated] * error[eliminated];
            }
        }
        if !lu.factorise() {
            return [f64::NAN; N];
        }
        lu.solve(&mut right);
        for (d, &row) in solved.iter().enumerate() {
            error[row] = right[d];
        }
        for (eliminated, source) in kinematic::<F, N>() {
            error[eliminated] += shift * error[source];
        }
        error
    }
}
