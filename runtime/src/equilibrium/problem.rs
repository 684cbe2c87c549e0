//! The zero problem of an equilibrium: f(y, r) = 0 in one mode.

use nalgebra::{DMatrix, DVector};

use super::Confined;
use crate::continuation::{Linearisation, ZeroProblem};
use crate::field::Work;
use crate::flow::{Family, Flow, FlowError, Place, Velocity};

type Mode<F, const N: usize> = <<F as Family<N>>::Flow as Flow<N>>::Mode;

/// Unknowns are the states; the equations are their rates.
#[derive(Debug, Clone)]
pub struct EquilibriumProblem<F: Family<N>, const N: usize> {
    /// The flows.
    pub family: F,
    /// The mode of the contacts.
    pub mode: Mode<F, N>,
    /// Evaluations so far.
    pub work: Work,
    magnitude: [f64; N],
    rates: [f64; N],
}

impl<F: Family<N>, const N: usize> EquilibriumProblem<F, N> {
    /// The problem of an equilibrium near `state`.
    pub fn new(family: F, mode: Mode<F, N>, state: &[f64; N]) -> Self {
        Self {
            family,
            mode,
            work: Work::default(),
            magnitude: state.map(|y| if y.abs() > TINY { y.abs() } else { 1.0 }),
            rates: [0.0; N],
        }
    }

    /// The place of these unknowns.
    #[must_use]
    pub fn place(&self, z: &DVector<f64>) -> Place<N, Mode<F, N>> {
        Place {
            state: std::array::from_fn(|j| z[j]),
            mode: self.mode,
        }
    }

    /// What errors of the equations weigh, from the first evaluation: how much the usual states change them.
    fn weigh(&mut self, jacobian: &[[f64; N]; N]) {
        for (i, rate) in self.rates.iter_mut().enumerate() {
            if *rate == 0.0 {
                *rate = (0..N)
                    .map(|j| (jacobian[i][j] * self.magnitude[j]).abs())
                    .sum();
            }
        }
    }

    fn rate(&self, i: usize) -> f64 {
        if self.rates[i] > 0.0 && self.rates[i].is_finite() {
            self.rates[i]
        } else {
            1.0
        }
    }
}

/// A state below this is rounding error, and its usual magnitude unknown.
const TINY: f64 = 1e-12;

impl<F: Family<N>, const N: usize> ZeroProblem for EquilibriumProblem<F, N>
where
    F::Flow: Confined<N>,
{
    type Error = FlowError;
    type Extra = Velocity<N>;

    fn evaluate(
        &mut self,
        z: &DVector<f64>,
        r: f64,
    ) -> Result<Linearisation<Velocity<N>>, FlowError> {
        let velocity = self.family.at(r)?.velocity(&self.place(z))?;
        self.work.linearisations += 1;
        self.work.newton += 1;
        self.weigh(&velocity.jacobian);
        Ok(Linearisation {
            residual: DVector::from_fn(N, |i, _| velocity.f[i] / self.rate(i)),
            jacobian: DMatrix::from_fn(N, N, |i, j| velocity.jacobian[i][j] / self.rate(i)),
            design: DVector::from_fn(N, |i, _| velocity.design[i] / self.rate(i)),
            extra: velocity,
        })
    }

    fn scale(&self) -> DVector<f64> {
        DVector::from_column_slice(&self.magnitude)
    }

    fn accept(
        &mut self,
        z: &DVector<f64>,
        r: f64,
        _velocity: &Velocity<N>,
    ) -> Result<Option<DVector<f64>>, FlowError> {
        self.family.at(r)?.check(&self.place(z))?;
        for (magnitude, y) in self.magnitude.iter_mut().zip(z) {
            *magnitude = magnitude.max(y.abs());
        }
        Ok(None)
    }
}
