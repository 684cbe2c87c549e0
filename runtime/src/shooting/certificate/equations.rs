//! The shooting equations in scaled units, and how much their derivative bends.

use nalgebra::{DMatrix, DVector};

use super::Uncertified;
use crate::continuation::ZeroProblem;
use crate::flow::{FlowError, Peaks};
use crate::integrate::Tolerance;
use crate::motion::{Family, Modes};
use crate::shooting::anchor::problem;
use crate::shooting::guess::Guess;
use crate::shooting::problem::OrbitProblem;

/// By how much a ball that is too large shrinks.
const SHRINK: f64 = 0.125;
/// What is reported of a Lipschitz constant over what samples show of it.
const SAMPLED: f64 = 2.0;

/// The shooting equations of one orbit with a flow at one tolerance.
pub(super) struct Equations {
    pub(super) problem: OrbitProblem,
    pub(super) start: DVector<f64>,
    r: f64,
}

/// The equations at one point, in scaled units, and the modes that the motion runs through.
pub(super) struct Values {
    pub(super) f: DVector<f64>,
    pub(super) df: DMatrix<f64>,
    word: Vec<Modes>,
}

impl Equations {
    pub(super) fn new(
        family: &Family,
        r: f64,
        orbit: &Guess,
        tolerance: Tolerance,
    ) -> Result<Self, FlowError> {
        let family = family.with_tolerance(tolerance);
        let family = family.with_magnitude(&orbit.magnitude);
        let (mut problem, start) = problem(family, r, orbit, 1)?;
        problem.want.extrema = Peaks::Nowhere;
        Ok(Self { problem, start, r })
    }

    pub(super) fn at(&mut self, z: &DVector<f64>) -> Result<Values, FlowError> {
        let there = self.problem.evaluate(z, self.r)?;
        let df = there.scaled(&self.problem.scale());
        let passages = there.extra.passages.iter();
        let segments = passages.flat_map(|passage| &passage.segments);
        Ok(Values {
            f: there.residual,
            df,
            word: segments.map(|segment| segment.modes.clone()).collect(),
        })
    }

    /// Lip(DF) in a ball of at least this radius around `here`; larger, up to `wide`, where rounding would hide it.
    pub(super) fn lipschitz(
        &mut self,
        here: &Values,
        least: f64,
        wide: f64,
    ) -> Result<f64, Uncertified> {
        let mut ball = least.max(wide);
        loop {
            match self.bend(here, ball) {
                Ok(bend) => return Ok(SAMPLED * bend),
                Err(_) if ball > least => ball = (SHRINK * ball).max(least),
                Err(error) => return Err(error),
            }
        }
    }

    /// |Σₖ ∂ₖDF| over the axes k of the ball, each taken both ways: to first order, no direction bends DF more.
    fn bend(&mut self, here: &Values, ball: f64) -> Result<f64, Uncertified> {
        let scale = self.problem.scale();
        let mut total = DMatrix::zeros(scale.len(), scale.len());
        for axis in 0..scale.len() {
            let mut most: DMatrix<f64> = DMatrix::zeros(scale.len(), scale.len());
            for sign in [1.0, -1.0] {
                let mut z = self.start.clone();
                z[axis] += sign * ball * scale[axis];
                let there = self.neighbour(&z, ball)?;
                if there.word != here.word {
                    return Err(Uncertified::WordChanges { radius: ball });
                }
                let change = (there.df - &here.df).abs() / ball;
                most.zip_apply(&change, |most, change| *most = most.max(change));
            }
            total += most;
        }
        Ok(norm(&total))
    }

    fn neighbour(&mut self, z: &DVector<f64>, radius: f64) -> Result<Values, Uncertified> {
        self.at(z).map_err(|reason| match reason {
            FlowError::OtherMode { .. } => Uncertified::WordChanges { radius },
            reason => Uncertified::Neighbour { radius, reason },
        })
    }
}

/// The largest sum of magnitudes in a row.
pub(super) fn norm(matrix: &DMatrix<f64>) -> f64 {
    let rows = matrix.row_iter().map(|row| row.abs().sum());
    rows.fold(0.0, f64::max)
}
