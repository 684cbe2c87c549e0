//! A point of a curve.

use nalgebra::{Complex, DVector};

use super::isola::Unfolding;
use crate::bifurcation::Floquet;
use crate::continuation::{Kind, Watched};
use crate::equilibrium::{EquilibriumProblem, Onset, Spectrum};
use crate::motion::Place;
use crate::shooting::{Orbit, problem};

/// What is special on a curve, an [`Orbit`] or a [`CriticalEquilibrium`], and where.
#[derive(Debug, Clone)]
pub struct CurvePoint<T> {
    /// The first design variable.
    pub p: f64,
    /// The second one.
    pub q: f64,
    /// What its curve measures q in.
    pub q_scale: f64,
    /// What is special; its residual includes that of the condition.
    pub of: T,
    /// The condition that makes it special, as it was met.
    pub test: f64,
    /// Components of the unit tangent along p and q, in scaled coordinates.
    pub tangent: [f64; 2],
    /// Which of p and q, the first or the second, stands still here along the curve, if it was found because one does.
    pub still: Option<usize>,
}

impl CurvePoint<Orbit> {
    /// Stability.
    #[must_use]
    pub fn floquet(&self) -> &Floquet {
        &self.of.floquet
    }
}

/// An equilibrium with an eigenvalue, or a pair of them, on the imaginary axis.
#[derive(Debug, Clone)]
pub struct CriticalEquilibrium {
    /// Where it is.
    pub place: Place,
    /// Its eigenvalues.
    pub spectrum: Spectrum,
    /// The pair with the sum zero, at a Hopf point: a complex one turns, a real one is that of a neutral saddle.
    pub pair: Option<[Complex<f64>; 2]>,
    /// How periodic motions begin there, if they do.
    pub onset: Option<Onset>,
    /// Of each contact that slides, presses or bears, see [`Flow::margins`](crate::motion::Flow::margins).
    pub margins: Vec<(usize, f64)>,
    /// Norm of the residual of its equations, that of the condition included.
    pub residual: f64,
}

impl CriticalEquilibrium {
    /// |Im λ| of the pair, if it turns.
    #[must_use]
    pub fn frequency(&self) -> Option<f64> {
        let [one, _] = self.pair?;
        (one.im != 0.0).then_some(one.im.abs())
    }
}

/// What may turn back, or exchange its branches, where a curve of folds stands still in one variable.
pub(super) trait Unfolds: Clone {
    /// What becomes of branches along the other variable at this (p, q).
    fn unfolded(&self, at: [f64; 2], unfolding: &Unfolding, still: usize) -> Option<Kind>;
}

impl Unfolds for Orbit {
    fn unfolded(&self, at: [f64; 2], unfolding: &Unfolding, still: usize) -> Option<Kind> {
        let guess = self.guess();
        unfolding.kind(at, still, |family, a| problem(family, a, &guess, 1))
    }
}

impl Unfolds for CriticalEquilibrium {
    fn unfolded(&self, at: [f64; 2], unfolding: &Unfolding, still: usize) -> Option<Kind> {
        unfolding.kind(at, still, |family, r| {
            let problem = EquilibriumProblem::new(family, r, &self.place);
            Ok((problem, DVector::from_column_slice(&self.place.state)))
        })
    }
}

impl<T: Clone> Watched for CurvePoint<T> {
    fn r(&self) -> f64 {
        self.q
    }

    fn r_scale(&self) -> f64 {
        self.q_scale
    }

    fn slope(&self) -> f64 {
        self.tangent[1]
    }

    fn moved(&self, from: &Self) -> f64 {
        moved([self.p, self.q], [from.p, from.q])
    }
}

/// How far a point moves in both variables, relative to their values.
pub(super) fn moved(to: [f64; 2], from: [f64; 2]) -> f64 {
    let relative = to
        .iter()
        .zip(from)
        .map(|(to, from)| ((to - from) / to).abs());
    relative.fold(0.0, f64::max)
}
