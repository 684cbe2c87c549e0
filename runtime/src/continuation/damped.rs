//! Newton's method from far away: steps as long as they bring it nearer.

use nalgebra::{DMatrix, DVector};

use super::corrector::{CONTRACTS, Failure};
use super::{Linearisation, ZeroProblem};

/// Most steps.
const STEPS: usize = 24;
/// Least share of a step that is tried.
const LEAST: f64 = 1.0 / 128.0;

/// Unknowns at this r from which [`correct_at`](super::correct_at) leads to a solution, as far as the next correction tells.
///
/// A share of a step is taken if what is left to go, by the same derivatives, falls with it (the natural test of Deuflhard
/// 1974): the residual itself may rise in directions that are amplified, and says less.
///
/// # Errors
/// See [`Failure`].
pub fn approach<P: ZeroProblem>(
    problem: &mut P,
    mut z: DVector<f64>,
    r: f64,
) -> Result<DVector<f64>, Failure<P::Error>> {
    let scale = problem.scale();
    let mut at = problem.evaluate(&z, r).map_err(Failure::Evaluation)?;
    let (mut share, mut size) = (1.0, f64::NAN);
    for _ in 0..STEPS {
        let solved = scaled(&at, &scale).lu();
        let solve = |there: &Linearisation<P::Extra>| solved.solve(&-&there.residual);
        let step = solve(&at).ok_or(Failure::Singular { r })?;
        size = step.norm();
        let (there, left) = loop {
            let tried = &z + share * step.component_mul(&scale);
            let failure = match problem.evaluate(&tried, r) {
                Ok(there) => match solve(&there).map(|left| left.norm()) {
                    Some(left) if left <= (1.0 - 0.5 * share) * size => {
                        z = tried;
                        break (there, left);
                    }
                    _ => Failure::NoConvergence {
                        correction: size,
                        r,
                    },
                },
                Err(error) => Failure::Evaluation(error),
            };
            share *= 0.5;
            if share < LEAST {
                return Err(failure);
            }
        };
        if share == 1.0 && left <= CONTRACTS * size {
            return Ok(z);
        }
        at = there;
        share = (2.0 * share).min(1.0);
    }
    Err(Failure::NoConvergence {
        correction: size,
        r,
    })
}

/// h_z in units of the unknowns.
fn scaled<Extra>(linearisation: &Linearisation<Extra>, scale: &DVector<f64>) -> DMatrix<f64> {
    let mut matrix = linearisation.jacobian.clone();
    for (mut column, unit) in matrix.column_iter_mut().zip(scale) {
        column *= *unit;
    }
    matrix
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use super::*;
    use crate::continuation::correct_at;

    /// arctan z₀ and a thousand times z₀ + z₁: from far away, steps of Newton's method lead ever further, and residuals tell
    /// of the second equation alone.
    struct Flattening;

    impl ZeroProblem for Flattening {
        type Error = Infallible;
        type Extra = ();

        fn evaluate(&mut self, z: &DVector<f64>, _: f64) -> Result<Linearisation<()>, Infallible> {
            let slope = 1.0 / (1.0 + z[0] * z[0]);
            Ok(Linearisation {
                residual: DVector::from_vec(vec![z[0].atan(), 1e3 * (z[0] + z[1])]),
                jacobian: DMatrix::from_row_slice(2, 2, &[slope, 0.0, 1e3, 1e3]),
                design: DVector::zeros(2),
                extra: (),
            })
        }

        fn scale(&self) -> DVector<f64> {
            DVector::from_vec(vec![1.0, 1.0])
        }
    }

    #[test]
    fn damped_steps_come_near_from_where_full_ones_lead_away() {
        let far = DVector::from_vec(vec![10.0, 0.0]);
        assert!(correct_at(&mut Flattening, far.clone(), 0.0, 1e-12).is_err());
        let near = approach(&mut Flattening, far, 0.0).expect("nearer");
        let found = correct_at(&mut Flattening, near, 0.0, 1e-12).expect("a solution");
        assert!(found.z.norm() < 1e-12, "{}", found.z);
    }
}
