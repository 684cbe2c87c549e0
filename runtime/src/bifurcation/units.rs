//! What becomes of disturbances, in units in which all states are of one size.

use nalgebra::{DMatrix, DVector};

use crate::motion::Factor;

/// Φ with the velocity at its start, and its factors, where they are wanted.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Disturbances {
    pub(crate) monodromy: DMatrix<f64>,
    pub(crate) velocity: DVector<f64>,
    pub(crate) factors: Vec<Factor>,
}

impl Disturbances {
    /// The same in units of states of these sizes, powers of 2, so that nothing is rounded; as it is where it is no larger.
    ///
    /// Φ errs relative to its largest entry in such units: of nanometres at megahertz, the speed that a metre would make
    /// says nothing of the errors of multipliers.
    pub(crate) fn in_units(self, sizes: &[f64]) -> Self {
        let units: Vec<f64> = sizes
            .iter()
            .map(|size| size.log2().round().exp2())
            .collect();
        let turned = |matrix: &DMatrix<f64>| {
            let entry = |i, j| matrix[(i, j)] * units[j] / units[i];
            DMatrix::from_fn(matrix.nrows(), matrix.ncols(), entry)
        };
        let monodromy = turned(&self.monodromy);
        let smaller = monodromy.amax() < self.monodromy.amax();
        if !smaller || !monodromy.iter().all(|entry| entry.is_finite()) {
            return self;
        }
        let factor = |factor: &Factor| Factor {
            state: turned(&factor.state),
            growth: factor.growth.as_ref().map(turned),
        };
        let scaled = self.velocity.iter().zip(&units).map(|(f, unit)| f / unit);
        Self {
            monodromy,
            velocity: DVector::from_iterator(units.len(), scaled),
            factors: self.factors.iter().map(factor).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bifurcation::{Stability, floquet};

    /// A resonator of 2e6 rad/s and Q = 400 that swings by 40 nm, over a period: |μ| = exp(−π/Q).
    #[test]
    fn units_of_the_model_say_nothing_of_what_decays() {
        let (rate, period) = (2e6, 1e-6 * std::f64::consts::PI);
        let shrinks = (-std::f64::consts::PI / 400.0).exp();
        let turned = 0.04_f64;
        let phi = [
            [shrinks * turned.cos(), shrinks * turned.sin() / rate, 0.0],
            [-shrinks * turned.sin() * rate, shrinks * turned.cos(), 0.0],
            [0.0, 0.0, 1.0],
        ];
        let all = Disturbances {
            monodromy: DMatrix::from_row_slice(3, 3, phi.as_flattened()),
            velocity: DVector::from_vec(vec![0.0, 0.0, std::f64::consts::TAU / period]),
            factors: Vec::new(),
        };
        let judged =
            |all: &Disturbances| floquet(&all.monodromy, &all.velocity, None, 0, &[], 0, 2.4e-8);
        assert_eq!(judged(&all).stability, Stability::Undecided);
        let all = all.in_units(&[4e-8, 0.08, 3.0]);
        let verdict = judged(&all);
        assert_eq!(verdict.stability, Stability::Stable);
        assert!((verdict.multipliers[0].norm() - shrinks).abs() < 1e-14);
        assert_eq!(all.clone().in_units(&[1.0, 1.0, 1.0]), all);
    }
}
