//! The stage system of one step, solved by full Newton with exact stage Jacobians.

use super::super::lu::Lu;
use super::layout::{Layout, kinematic, position};
use super::{NEWTON_ITERATIONS, Radau, add};
use crate::field::{Field, Linear};
use crate::scalar::dot;

/// What Newton may leave undone of the tolerated error.
const NEWTON_REST: f64 = 3e-3;
/// Size of the corrections that rounding keeps alive, relative to a component.
const ROUNDING: f64 = 2.0 * f64::EPSILON;

/// The solved stages of one step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Trial<const N: usize, const S: usize> {
    pub(super) step: f64,
    pub(super) start: [f64; N],
    pub(super) increments: [[f64; N]; S],
    pub(super) linear: [Linear<N>; S],
    pub(super) correction: [f64; N],
    pub(super) lu: Lu<N, S>,
    pub(super) iterations: usize,
}

impl<F: Field<N>, const N: usize, const S: usize> Radau<'_, F, N, S> {
    /// Newton on the stage system; `None` if it does not converge.
    pub(super) fn solve(&mut self, step: f64, guess: [[f64; N]; S]) -> Option<Trial<N, S>> {
        let mut trial = Trial::blank(self.state, self.start);
        trial.step = step;
        trial.increments = guess;
        self.follow_kinematics(&mut trial);
        let scale = self.scale(&trial.end());
        let mut before = f64::INFINITY;
        for iteration in 1..=NEWTON_ITERATIONS {
            for i in 0..S {
                trial.linear[i] = self
                    .field
                    .linearise(&add(&trial.start, &trial.increments[i]));
            }
            self.work.linearisations += S as u64;
            self.work.factorisations += 1;
            if !self.assemble(&mut trial) {
                return None;
            }
            let size = self.correct(&mut trial, &scale);
            if !size.is_finite() || (iteration > 2 && size > 2.0 * before) {
                return None;
            }
            let rate = if before.is_finite() {
                (size / before).min(1.0)
            } else {
                1.0
            };
            trial.iterations = iteration;
            if size * rate <= NEWTON_REST || size <= 1e-2 * NEWTON_REST {
                return Some(trial);
            }
            before = size;
        }
        None
    }

    /// What errors are measured against at `y`, never below what its digits resolve.
    pub(super) fn scale(&self, y: &[f64; N]) -> [f64; N] {
        let scale = self.field.scale(y, &self.tolerance);
        crate::scalar::filled(|j| scale[j].max(ROUNDING / NEWTON_REST * y[j].abs()))
    }

    /// I − h A∘J with the kinematic rows eliminated; false if it is singular.
    fn assemble(&self, trial: &mut Trial<N, S>) -> bool {
        let (solved, h, a) = (Layout::<F, N>::solved(), trial.step, &self.tableau.matrix);
        let width = solved.len();
        trial.lu = Lu::zero(S * width);
        for i in 0..S {
            for (d, &row) in solved.iter().enumerate() {
                let out = trial.lu.row(i * width + d);
                for j in 0..S {
                    let slopes = &trial.linear[j].jacobian[row];
                    for (c, &column) in solved.iter().enumerate() {
                        out[j * width + c] -= h * a[i][j] * slopes[column];
                    }
                    for (eliminated, source) in kinematic::<F, N>() {
                        let weight = h * h * a[i][j] * slopes[eliminated];
                        if weight != 0.0 {
                            let c = position(solved, source);
                            for k in 0..S {
                                out[k * width + c] -= weight * a[j][k];
                            }
                        }
                    }
                }
                out[i * width + d] += 1.0;
            }
        }
        trial.lu.factorise()
    }

    /// One Newton correction; returns its size relative to what is tolerated.
    fn correct(&self, trial: &mut Trial<N, S>, scale: &[f64; N]) -> f64 {
        let (solved, h, a) = (Layout::<F, N>::solved(), trial.step, &self.tableau.matrix);
        let width = solved.len();
        let mut right = [[0.0; N]; S];
        let flat = right.as_flattened_mut();
        for i in 0..S {
            for (d, &row) in solved.iter().enumerate() {
                let sum: f64 = (0..S).map(|j| a[i][j] * trial.linear[j].f[row]).sum();
                flat[i * width + d] = h * sum - trial.increments[i][row];
            }
        }
        trial.lu.solve(flat);
        let mut largest = 0.0_f64;
        for i in 0..S {
            for (d, &row) in solved.iter().enumerate() {
                let correction = flat[i * width + d];
                trial.increments[i][row] += correction;
                let beyond = correction.abs() / scale[row];
                // `max` would hide a NaN.
                largest = if beyond > largest || beyond.is_nan() {
                    beyond
                } else {
                    largest
                };
            }
        }
        let old = trial.increments[S - 1];
        self.follow_kinematics(trial);
        let new = trial.increments[S - 1];
        trial.correction = crate::scalar::filled(|j| new[j] - old[j]);
        for (d, &row) in solved.iter().enumerate() {
            trial.correction[row] = flat[(S - 1) * width + d];
        }
        largest
    }

    /// Stage increments of the eliminated rows: h A (y₀ⱼ + Zⱼ).
    fn follow_kinematics(&self, trial: &mut Trial<N, S>) {
        for (eliminated, source) in kinematic::<F, N>() {
            for i in 0..S {
                let row = &self.tableau.matrix[i];
                let sum: f64 = (0..S)
                    .map(|j| row[j] * (trial.start[source] + trial.increments[j][source]))
                    .sum();
                trial.increments[i][eliminated] = trial.step * sum;
            }
        }
    }
}

impl<const N: usize, const S: usize> Trial<N, S> {
    pub(super) fn blank(start: [f64; N], linear: Linear<N>) -> Self {
        Self {
            step: 0.0,
            start,
            increments: [[0.0; N]; S],
            linear: [linear; S],
            correction: [0.0; N],
            lu: Lu::zero(0),
            iterations: 0,
        }
    }

    pub(super) fn end(&self) -> [f64; N] {
        add(&self.start, &self.increments[S - 1])
    }

    /// The field at the end: that of the last iterate, moved by the last correction.
    pub(super) fn arrival(&self) -> Linear<N> {
        let mut linear = self.linear[S - 1];
        for i in 0..N {
            linear.f[i] += dot(&linear.jacobian[i], &self.correction);
        }
        linear
    }
}
