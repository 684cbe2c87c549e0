//! Path following of the zeros of h(z, r) through folds: thesis section 2.3 (Fey 1992).
//!
//! Knows a zero problem and nothing of orbits.

mod attempt;
mod between;
mod branch;
mod change;
mod corner;
mod corrector;
mod creep;
mod crossing;
mod damped;
mod detect;
mod ending;
mod exchange;
mod gap;
mod kind;
mod link;
mod located;
mod margin;
mod measure;
mod monitor;
mod path;
mod plateau;
mod point;
mod predictor;
mod range;
mod reading;
mod root;
mod round;
mod step;
mod switch;
mod unknowns;
mod walk;

pub use branch::{Branch, Started};
pub(crate) use corrector::CLOSED;
pub use corrector::{Corrected, Failure, correct, correct_at};
pub use crossing::{Beyond, Crossing};
pub(crate) use damped::{approach, damped};
pub use detect::detect;
pub use ending::{Ending, Lost};
pub use kind::Kind;
pub use link::Link;
pub use located::{Findings, Located, Unexplained};
pub(crate) use measure::own_scale;
pub use monitor::{Monitor, Verdict, changes, rests};
pub use path::{Border, Chance, Path, Spot, Watched};
pub use point::Point;
pub(crate) use predictor::tangent;
pub use range::{Settings, Stop};
pub use reading::{ErrorOf, Reader, Reading};
pub(crate) use root::SETTLED;
pub use root::reach;
pub use switch::across;
pub use walk::{Walked, follow, walk};

use nalgebra::{DMatrix, DVector};

/// n equations h(z, r) = 0 in n unknowns z and one design variable r.
pub trait ZeroProblem {
    /// Whether its residual may rise on the way to a solution, as it is amplified more in some directions than in others:
    /// then corrections tell alone whether Newton's method converges (Deuflhard 1974).
    const AMPLIFIES: bool = false;

    /// Why the equations could not be evaluated.
    type Error: std::error::Error + Clone;
    /// What an evaluation yields beside the equations, kept with an accepted point.
    type Extra: Clone;

    /// h and its derivatives at (z, r).
    ///
    /// # Errors
    /// The equations cannot be evaluated there; the step is then made smaller.
    fn evaluate(
        &mut self,
        z: &DVector<f64>,
        r: f64,
    ) -> Result<Linearisation<Self::Extra>, Self::Error>;

    /// Whether two evaluations are of one smooth piece of h. Between two pieces that both lead to the other one corrections
    /// stall as they do in rounding errors, and there is no solution.
    fn same_piece(_one: &Self::Extra, _other: &Self::Extra) -> bool {
        true
    }

    /// Whether they may be of one solution, in other unknowns.
    fn as_eventful(_one: &Self::Extra, _other: &Self::Extra) -> bool {
        true
    }

    /// Whether both are of one h that is continuous: what singles out solutions may have become another condition.
    fn continuous(_one: &Self::Extra, _other: &Self::Extra) -> bool {
        true
    }

    /// Usual magnitudes of the unknowns: angles, lengths and corrections are measured in these.
    fn scale(&self) -> DVector<f64>;

    /// Told of each accepted point, so that the problem can follow the branch with what it fixes
    /// (a phase condition, say). It may return other unknowns for the same solution, and is then
    /// evaluated anew.
    ///
    /// # Errors
    /// The point is no solution of the kind sought; the branch ends there.
    fn accept(
        &mut self,
        _z: &DVector<f64>,
        _r: f64,
        _extra: &Self::Extra,
    ) -> Result<Option<DVector<f64>>, Self::Error> {
        Ok(None)
    }

    /// Whether a branch ends at once where a point is refused for this reason; else it is told as the end where shorter steps
    /// have come to it.
    fn ends(_why: &Self::Error) -> bool {
        true
    }

    /// Other unknowns for the solution accepted last, at this r: tried where no step succeeds, with
    /// `trial` = 0, 1, ... until there are none left.
    fn elsewhere(&mut self, _r: f64, _trial: usize) -> Option<DVector<f64>> {
        None
    }

    /// The part of a tangent (scaled, r last) that keeps its meaning when the unknowns are changed for others.
    fn lasting(&self, tangent: &DVector<f64>) -> DVector<f64> {
        tangent.clone()
    }
}

/// A zero problem at one point.
#[derive(Debug, Clone)]
pub struct Linearisation<Extra> {
    /// h, in units in which errors of all equations weigh the same.
    pub residual: DVector<f64>,
    /// ∂h/∂z.
    pub jacobian: DMatrix<f64>,
    /// ∂h/∂r.
    pub design: DVector<f64>,
    /// Whatever else was found.
    pub extra: Extra,
}

impl<Extra> Linearisation<Extra> {
    /// ∂h/∂z in units of the unknowns.
    pub(crate) fn scaled(&self, scale: &DVector<f64>) -> DMatrix<f64> {
        let mut matrix = self.jacobian.clone();
        for (mut column, unit) in matrix.column_iter_mut().zip(scale) {
            column *= *unit;
        }
        matrix
    }
}
