//! Newton's corrector on a bordered system: thesis (2.18) to (2.20).

use nalgebra::{DMatrix, DVector};

use super::point::unit;
use super::{Linearisation, ZeroProblem};
use crate::linear::solved;

/// Most iterations of one correction.
const ITERATIONS: usize = 12;
/// A stalled iteration this many times above the accuracy asked for still counts as converged, on one smooth piece of the
/// equations: below that, what is left is the noise of the residual itself.
const NOISE: f64 = 30.0;

/// A residual this many times above the accuracy is no solution, however small the correction: where
/// the motion amplifies strongly, a negligible correction can leave a gap that is not.
pub(crate) const CLOSED: f64 = 1e3;

/// Share of the last correction up to which the next one shows that Newton's method converges.
pub(super) const CONTRACTS: f64 = 0.25;
/// So many corrections in a row that do not shrink by more show that it creeps.
const ALIKE: usize = 3;

/// Why a correction failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Failure<E> {
    /// The residual did not fall monotonically: (2.20).
    #[error("Newton's method leaves: what does not vanish grew from {before:.2e} to {after:.2e}")]
    ResidualRose {
        /// Norm before.
        before: f64,
        /// Norm after.
        after: f64,
        /// Design variable.
        r: f64,
    },
    /// Newton did not converge within its iterations.
    #[error("Newton's method does not settle: its last correction was {correction:.2e}")]
    NoConvergence {
        /// Norm of the last correction.
        correction: f64,
        /// Design variable.
        r: f64,
    },
    /// The bordered matrix is singular: (2.23).
    #[error("its equations are singular there, so that they single out no solution")]
    Singular {
        /// Design variable.
        r: f64,
    },
    /// The corrected point lies too far off the tangent (2.21), or on another branch (2.22).
    #[error("the branch turns by {beta_1:.3} rad, its unknowns by {beta_2:.3} rad")]
    Angle {
        /// Angle between tangent and chord.
        beta_1: f64,
        /// The same without the design variable.
        beta_2: f64,
        /// Design variable.
        r: f64,
    },
    /// The equations could not be evaluated.
    #[error(transparent)]
    Evaluation(E),
}

impl<E> Failure<E> {
    /// Whether the equations are regular, and no solution was met that the branch leads to.
    pub(super) fn misses(&self) -> bool {
        !matches!(self, Self::Singular { .. } | Self::Evaluation(_))
    }
}

/// A converged point.
#[derive(Debug, Clone)]
pub struct Corrected<Extra> {
    /// Unknowns.
    pub z: DVector<f64>,
    /// Design variable.
    pub r: f64,
    /// The last evaluation, one negligible correction away from `z`.
    pub linearisation: Linearisation<Extra>,
    /// Norm of the residual there.
    pub residual: f64,
    /// Norms of all corrections, in units of the scale.
    pub corrections: Vec<f64>,
}

impl<Extra> Corrected<Extra> {
    /// Whether its last corrections shrank by about the same share each time: solutions meet there, or a family of them ends.
    pub(crate) fn creeps(&self) -> bool {
        let shrank = |two: &[f64]| two[1] > CONTRACTS * two[0];
        let last = self.corrections.iter().rev().take(ALIKE + 1);
        let last: Vec<f64> = last.rev().copied().collect();
        last.len() > ALIKE && last.windows(2).all(shrank)
    }
}

/// Corrects (z, r) along the hyperplane orthogonal to `normal` (scaled coordinates, r last) until a
/// correction is at most `accuracy` times the scale. With `normal` = (0, ..., 0, 1), r stays fixed.
///
/// # Errors
/// See [`Failure`].
pub fn correct<P: ZeroProblem>(
    problem: &mut P,
    mut z: DVector<f64>,
    mut r: f64,
    normal: &DVector<f64>,
    r_scale: f64,
    accuracy: f64,
) -> Result<Corrected<P::Extra>, Failure<P::Error>> {
    let scale = problem.scale();
    let n = scale.len();
    let mut corrections: Vec<f64> = Vec::new();
    let mut before = f64::INFINITY;
    let mut previous: Option<P::Extra> = None;
    for _ in 0..ITERATIONS {
        let linearisation = problem.evaluate(&z, r).map_err(Failure::Evaluation)?;
        let residual = linearisation.residual.norm();
        let last = corrections.last().copied();
        let settled = last.is_some_and(|last| last <= NOISE * accuracy);
        let rose = Failure::ResidualRose {
            before,
            after: residual,
            r,
        };
        let rises = residual >= before && !settled && residual > accuracy;
        if rises && !P::AMPLIFIES {
            return Err(rose);
        }
        let bordered = bordered(&linearisation, &scale, r_scale, normal);
        let mut right = DVector::zeros(n + 1);
        right.rows_mut(0, n).copy_from(&(-&linearisation.residual));
        let correction = solved(&bordered, &right).ok_or(Failure::Singular { r })?;
        let size = correction.norm();
        if rises && last.is_none_or(|last| size > CONTRACTS * last) {
            return Err(rose);
        }
        z += correction.rows(0, n).component_mul(&scale);
        r += correction[n] * r_scale;
        corrections.push(size);
        let noise = last.is_some_and(|last| size > 0.3 * last) && size <= NOISE * accuracy;
        let smooth = |extra: &P::Extra| P::same_piece(extra, &linearisation.extra);
        let stalled = noise && previous.as_ref().is_some_and(smooth);
        let settles = size <= accuracy && residual <= CLOSED * accuracy;
        if settles || stalled && residual <= NOISE * accuracy {
            return Ok(Corrected {
                z,
                r,
                linearisation,
                residual,
                corrections,
            });
        }
        before = residual;
        previous = Some(linearisation.extra);
    }
    let correction = corrections.last().copied().unwrap_or(f64::NAN);
    Err(Failure::NoConvergence { correction, r })
}

/// Corrects z at this r until a correction is at most `accuracy` times the scale.
///
/// # Errors
/// See [`Failure`].
pub fn correct_at<P: ZeroProblem>(
    problem: &mut P,
    z: DVector<f64>,
    r: f64,
    accuracy: f64,
) -> Result<Corrected<P::Extra>, Failure<P::Error>> {
    let normal = unit(z.len());
    correct(problem, z, r, &normal, 1.0, accuracy)
}

/// [h_z h_r; normal] in scaled coordinates.
pub(super) fn bordered<Extra>(
    linearisation: &Linearisation<Extra>,
    scale: &DVector<f64>,
    r_scale: f64,
    normal: &DVector<f64>,
) -> DMatrix<f64> {
    let n = scale.len();
    DMatrix::from_fn(n + 1, n + 1, |i, j| match (i == n, j == n) {
        (true, _) => normal[j],
        (false, true) => linearisation.design[i] * r_scale,
        (false, false) => linearisation.jacobian[(i, j)] * scale[j],
    })
}
