//! How near a true orbit is to a computed one: Newton and Kantorovich's theorem, its constants taken from numbers.

use nalgebra::{DMatrix, DVector};

use super::anchor::problem;
use super::converge::{CHANCE, DOUBT, TIGHTER};
use super::guess::Guess;
use super::problem::OrbitProblem;
use crate::continuation::ZeroProblem;
use crate::flow::{Family, Flow, FlowError};
use crate::integrate::Tolerance;

type Mode<F, const N: usize> = <<F as Family<N>>::Flow as Flow<N>>::Mode;

/// The ball in which derivatives are compared, over the length of Newton's step; the radius is at most 2 of them.
const BALL: f64 = 4.0;
/// By how much a ball that is too large shrinks.
const SHRINK: f64 = 0.125;
/// What is reported of a Lipschitz constant over what samples show of it.
const SAMPLED: f64 = 2.0;

/// A true orbit lies within these radii of a computed one, and no other: a posteriori, not rigorous.
///
/// With F the shooting equations, in units of the states' half extents and of the period, and ∞-norms:
/// h = |DF⁻¹| · |DF⁻¹F| · Lip(DF) ≤ ½ gives a zero of F within (1 − √(1 − 2h)) / (|DF⁻¹| Lip(DF)). Not rigorous, because
/// Lip(DF) is sampled and the errors of the integration are those that a tighter tolerance shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Certificate {
    /// The computed start, to which the radii belong.
    pub start: Vec<f64>,
    /// The computed period.
    pub period: f64,
    /// How far each state of the true start is from it at most, in the units of the state.
    pub state_radius: Vec<f64>,
    /// How far the true period is from it at most.
    pub period_radius: f64,
    /// The constants of the theorem.
    pub constants: Constants,
}

/// What the theorem asks for, all of it in scaled units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants {
    /// |F|, the error of the integration included.
    pub residual: f64,
    /// The error of the integration alone.
    pub integration: f64,
    /// |DF⁻¹|, the error of DF included.
    pub inverse: f64,
    /// |DF⁻¹F|, the length of Newton's step, the error of the integration included.
    pub step: f64,
    /// Lip(DF), from samples.
    pub lipschitz: f64,
    /// Their product; at most ½ where there is a certificate.
    pub h: f64,
}

/// Why an orbit has no certificate.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Uncertified {
    /// The shooting equations have no isolated zero, as far as numbers can tell.
    #[error(
        "DF, the derivative of the shooting equations, cannot be inverted as far as numbers can tell: |DF⁻¹| is \
         {inverse:.1e}, and times the error of DF it is {doubt:.1e}, where less than 1 is needed"
    )]
    Singular {
        /// |DF⁻¹|; infinite if there is none.
        inverse: f64,
        /// The same times how well DF is known.
        doubt: f64,
    },
    /// Newton and Kantorovich's condition does not hold.
    #[error(
        "h = |DF⁻¹| |DF⁻¹F| Lip(DF) = {:.1e} × {:.1e} × {:.1e} = {:.2e} is above 1/2: the residual {:.1e} is too large for \
         how fast DF changes", .0.inverse, .0.step, .0.lipschitz, .0.h, .0.residual
    )]
    TooFar(Constants),
    /// The exact system runs through other modes next to the orbit, where its derivatives are others.
    #[error(
        "within {radius:.1e} of the orbit, relative to its extent, contacts slide and stick in another order: the \
         derivatives there are others"
    )]
    WordChanges {
        /// Distance, relative to the extents of the states.
        radius: f64,
    },
    /// Motions next to the orbit cannot be followed, or have no derivative.
    #[error(
        "within {radius:.1e} of the orbit, relative to its extent, a motion cannot be differentiated: {reason}"
    )]
    Neighbour {
        /// Distance, relative to the extents of the states.
        radius: f64,
        /// Why.
        reason: FlowError,
    },
    /// The orbit itself cannot be followed.
    #[error("the orbit itself cannot be followed: {0}")]
    Flow(#[from] FlowError),
}

/// The certificate of a computed orbit that begins in `orbit.place`, as computed to this relative accuracy.
///
/// # Errors
/// See [`Uncertified`].
pub fn certify<F: Family<N> + Clone, const N: usize>(
    family: &F,
    r: f64,
    orbit: &Guess<N, Mode<F, N>>,
    accuracy: f64,
) -> Result<Certificate, Uncertified> {
    let tolerance = Tolerance::for_accuracy(accuracy).times(TIGHTER);
    let mut loose = Equations::new(family, r, orbit, tolerance)?;
    let tolerance = tolerance.times(TIGHTER);
    let mut tight = Equations::new(family, r, orbit, tolerance)?;
    let here = tight.at(&tight.start.clone())?;
    let before = loose.at(&loose.start.clone())?;
    // Two runs may agree by chance: no error is below what a tolerance lets through.
    let least = CHANCE * tolerance.explicit().relative;
    let error = (&before.f - &here.f).map(|gap| (DOUBT * gap.abs()).max(least));
    let gap = (&before.df - &here.df).abs() * DOUBT + here.df.abs() * least;
    let inverse = here.df.clone().try_inverse();
    let inverse = inverse.filter(|inverse| inverse.iter().all(|entry| entry.is_finite()));
    let inverse = inverse.ok_or(Uncertified::Singular {
        inverse: f64::INFINITY,
        doubt: f64::INFINITY,
    })?;
    let size = norm(&inverse);
    let doubt = norm(&(inverse.abs() * &gap));
    if doubt.is_nan() || doubt >= 1.0 {
        return Err(Uncertified::Singular {
            inverse: size,
            doubt,
        });
    }
    let known = 1.0 - doubt;
    let newton = (&inverse * &here.f).abs() + inverse.abs() * &error;
    let (beta, step) = (size / known, newton.amax() / known);
    let lipschitz = tight.lipschitz(&here, BALL * step, norm(&gap).sqrt())?;
    let constants = Constants {
        residual: (here.f.abs() + &error).amax(),
        integration: error.amax(),
        inverse: beta,
        step,
        lipschitz,
        h: beta * step * lipschitz,
    };
    let radius = radius(&constants).ok_or(Uncertified::TooFar(constants))?;
    let radii = tight.problem.scale() * radius;
    Ok(Certificate {
        start: orbit.place.state.to_vec(),
        period: orbit.period,
        state_radius: radii.iter().take(N).copied().collect(),
        period_radius: radii[N],
        constants,
    })
}

/// (1 − √(1 − 2h)) / (|DF⁻¹| Lip), written so that nothing cancels; `None` for h > ½.
fn radius(constants: &Constants) -> Option<f64> {
    let Constants { step, h, .. } = *constants;
    (h <= 0.5).then(|| 2.0 * step / (1.0 + (1.0 - 2.0 * h).sqrt()))
}

/// The largest sum of magnitudes in a row.
fn norm(matrix: &DMatrix<f64>) -> f64 {
    let rows = matrix.row_iter().map(|row| row.abs().sum());
    rows.fold(0.0, f64::max)
}

/// The shooting equations of one orbit with a flow at one tolerance.
struct Equations<F: Family<N>, const N: usize> {
    problem: OrbitProblem<F, N>,
    start: DVector<f64>,
    r: f64,
}

/// The equations at one point, in scaled units, and the modes that the motion runs through.
struct Values<Mode> {
    f: DVector<f64>,
    df: DMatrix<f64>,
    word: Vec<Mode>,
}

impl<F: Family<N> + Clone, const N: usize> Equations<F, N> {
    fn new(
        family: &F,
        r: f64,
        orbit: &Guess<N, Mode<F, N>>,
        tolerance: Tolerance,
    ) -> Result<Self, FlowError> {
        let family = family.with_tolerance(tolerance);
        let family = family.with_magnitude(orbit.magnitude);
        let (mut problem, start) = problem(family, r, orbit, 1)?;
        problem.want.extrema = false;
        Ok(Self { problem, start, r })
    }

    fn at(&mut self, z: &DVector<f64>) -> Result<Values<Mode<F, N>>, FlowError> {
        let there = self.problem.evaluate(z, self.r)?;
        let mut df = there.jacobian;
        for (mut column, unit) in df.column_iter_mut().zip(&self.problem.scale()) {
            column *= *unit;
        }
        let passages = there.extra.passages.iter();
        let segments = passages.flat_map(|passage| &passage.segments);
        Ok(Values {
            f: there.residual,
            df,
            word: segments.map(|segment| segment.mode).collect(),
        })
    }

    /// Lip(DF) in a ball of at least this radius around `here`; larger, up to `wide`, where rounding would hide it.
    fn lipschitz(
        &mut self,
        here: &Values<Mode<F, N>>,
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
    fn bend(&mut self, here: &Values<Mode<F, N>>, ball: f64) -> Result<f64, Uncertified> {
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

    fn neighbour(
        &mut self,
        z: &DVector<f64>,
        radius: f64,
    ) -> Result<Values<Mode<F, N>>, Uncertified> {
        self.at(z).map_err(|reason| match reason {
            FlowError::OtherMode { .. } => Uncertified::WordChanges { radius },
            reason => Uncertified::Neighbour { radius, reason },
        })
    }
}
