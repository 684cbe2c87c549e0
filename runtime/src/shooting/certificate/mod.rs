//! How near a true orbit is to a computed one: Newton and Kantorovich's theorem, its constants taken from numbers.

mod equations;

use nalgebra::DMatrix;
use serde::Serialize;

use super::converge::{CHANCE, DOUBT, TIGHTER};
use super::guess::Guess;
use crate::continuation::ZeroProblem;
use crate::flow::FlowError;
use crate::integrate::Tolerance;
use crate::motion::Family;
use equations::{Equations, norm};

/// The ball in which derivatives are compared, over the length of Newton's step; the radius is at most 2 of them.
const BALL: f64 = 4.0;

/// A true orbit lies within these radii of a computed one, and no other: a posteriori, not rigorous.
///
/// With F the shooting equations, in units of the states' half extents and of the period, and ∞-norms:
/// h = |DF⁻¹| · |DF⁻¹F| · Lip(DF) ≤ ½ gives a zero of F within (1 − √(1 − 2h)) / (|DF⁻¹| Lip(DF)). Not rigorous, because
/// Lip(DF) is sampled and the errors of the integration are those that a tighter tolerance shows.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Certificate {
    /// The computed start, to which the radii belong.
    pub start: Vec<f64>,
    /// The computed period.
    #[serde(skip)]
    pub period: f64,
    /// How far each state of the true start is from it at most, in the units of the state.
    pub state_radius: Vec<f64>,
    /// How far the true period is from it at most.
    pub period_radius: f64,
    /// The constants of the theorem.
    #[serde(flatten)]
    pub constants: Constants,
}

/// What the theorem asks for, all of it in scaled units.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Constants {
    /// |F|, the error of the integration included.
    pub residual: f64,
    /// The error of the integration alone.
    #[serde(rename = "integration_error")]
    pub integration: f64,
    /// |DF⁻¹|, the error of DF included.
    #[serde(rename = "inverse_norm")]
    pub inverse: f64,
    /// |DF⁻¹F|, the length of Newton's step, the error of the integration included.
    #[serde(rename = "newton_step")]
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
pub fn certify(
    family: &Family,
    r: f64,
    orbit: &Guess,
    accuracy: f64,
) -> Result<Certificate, Uncertified> {
    // What is singled out by a condition only is no isolated orbit.
    let orbit = &Guess {
        pins: Vec::new(),
        division: None,
        ..orbit.clone()
    };
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
    let Inverse {
        matrix,
        size,
        known,
    } = Inverse::new(&here.df, &gap)?;
    let newton = (&matrix * &here.f).abs() + matrix.abs() * &error;
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
        start: orbit.place.state.clone(),
        period: orbit.period,
        state_radius: radii.iter().take(family.order()).copied().collect(),
        period_radius: radii[family.order()],
        constants,
    })
}

/// (1 − √(1 − 2h)) / (|DF⁻¹| Lip), written so that nothing cancels; `None` for h > ½.
fn radius(constants: &Constants) -> Option<f64> {
    let Constants { step, h, .. } = *constants;
    (h <= 0.5).then(|| 2.0 * step / (1.0 + (1.0 - 2.0 * h).sqrt()))
}

/// The inverse of a derivative that is known to some error.
struct Inverse {
    matrix: DMatrix<f64>,
    size: f64,
    /// 1 − |DF⁻¹ · error|: the norm of the true inverse is at most `size` over it.
    known: f64,
}

impl Inverse {
    fn new(df: &DMatrix<f64>, error: &DMatrix<f64>) -> Result<Self, Uncertified> {
        let inverse = df.clone().try_inverse();
        let finite = inverse.filter(|inverse| inverse.iter().all(|entry| entry.is_finite()));
        let matrix = finite.ok_or(Uncertified::Singular {
            inverse: f64::INFINITY,
            doubt: f64::INFINITY,
        })?;
        let (size, doubt) = (norm(&matrix), norm(&(matrix.abs() * error)));
        if doubt.is_nan() || doubt >= 1.0 {
            let inverse = size;
            return Err(Uncertified::Singular { inverse, doubt });
        }
        Ok(Self {
            matrix,
            size,
            known: 1.0 - doubt,
        })
    }
}
