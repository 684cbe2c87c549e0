//! The exact derivative of a discrete step: one more solve with the last factorisation.

use super::Radau;
use super::layout::{Layout, kinematic, position};
use crate::field::Field;
use crate::integrate::Propagator;
use crate::scalar::dot;

impl<F: Field<N>, const N: usize, const S: usize> Radau<'_, F, N, S> {
    /// The exact derivative of the last accepted step with respect to its start, the design variable and its length.
    #[must_use]
    pub fn propagator(&self) -> Propagator<N> {
        let mut propagator = Propagator::IDENTITY;
        // A guard may fall where a step begins.
        if self.last.step == 0.0 {
            return propagator;
        }
        for column in 0..N {
            let mut direction = [0.0; N];
            direction[column] = 1.0;
            let end = self.transport(&direction, 0.0, 0.0);
            for row in 0..N {
                propagator.state[row][column] = end[row];
            }
        }
        propagator.design = self.transport(&[0.0; N], 1.0, 0.0);
        propagator.time = self.transport(&[0.0; N], 0.0, 1.0);
        let quadrature = &self.tableau.matrix[S - 1];
        propagator.trace = self.last.step
            * (0..S)
                .map(|i| quadrature[i] * self.last.linear[i].trace())
                .sum::<f64>();
        propagator
    }

    /// ∫ J dt over the last accepted step.
    #[must_use]
    pub fn growth(&self) -> [[f64; N]; N] {
        let weights = &self.tableau.matrix[S - 1];
        let entry = |row: usize, column: usize| -> f64 {
            (0..S)
                .map(|i| weights[i] * self.last.linear[i].jacobian[row][column])
                .sum()
        };
        crate::scalar::filled(|row| {
            crate::scalar::filled(|column| self.last.step * entry(row, column))
        })
    }

    /// Differentiates the stage equations along (δy₀, δr, δh) and returns δy₁.
    fn transport(&self, start: &[f64; N], design: f64, length: f64) -> [f64; N] {
        let (trial, solved, a) = (&self.last, Layout::<F, N>::solved(), &self.tableau.matrix);
        let (h, width, nodes) = (trial.step, solved.len(), &self.tableau.nodes);
        // Stage velocities of the eliminated rows' sources, for the part that is known beforehand.
        let known: [[f64; N]; S] = crate::scalar::filled(|j| {
            let mut stage = *start;
            for (eliminated, source) in kinematic::<F, N>() {
                stage[eliminated] += h * nodes[j] * start[source];
                stage[eliminated] += length * trial.increments[j][eliminated] / h;
            }
            stage
        });
        let slope: [[f64; N]; S] = crate::scalar::filled(|j| {
            let linear = &trial.linear[j];
            crate::scalar::filled(|row| {
                dot(&linear.jacobian[row], &known[j]) + linear.design[row] * design
            })
        });
        let mut right = [[0.0; N]; S];
        let flat = right.as_flattened_mut();
        for i in 0..S {
            for (d, &row) in solved.iter().enumerate() {
                let sum: f64 = (0..S).map(|j| a[i][j] * slope[j][row]).sum();
                flat[i * width + d] = h * sum + length * trial.increments[i][row] / h;
            }
        }
        trial.lu.solve(flat);
        let mut end = known[S - 1];
        for (d, &row) in solved.iter().enumerate() {
            end[row] = start[row] + flat[(S - 1) * width + d];
        }
        for (eliminated, source) in kinematic::<F, N>() {
            let c = position(solved, source);
            end[eliminated] += h
                * (0..S)
                    .map(|j| a[S - 1][j] * flat[j * width + c])
                    .sum::<f64>();
        }
        end
    }
}
