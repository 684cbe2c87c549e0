//! Newton's method from far away: steps as long as they bring it nearer.

use nalgebra::DVector;

use super::corrector::CONTRACTS;
use super::{Linearisation, ZeroProblem};

/// Most steps.
const STEPS: usize = 24;
/// Least share of a step that is tried.
const LEAST: f64 = 1.0 / 128.0;

/// Where a share of a step has led.
pub(crate) struct Damped<Extra> {
    /// Unknowns.
    pub(crate) z: DVector<f64>,
    /// The equations there.
    pub(crate) at: Linearisation<Extra>,
    /// How large the next step would be by the derivatives of this one.
    left: f64,
    share: f64,
}

/// The first share of a step, halved from one of them down to another, after which what is `left` to go by the same derivatives
/// is no more than what `most` is for that share: the natural test of Deuflhard (1974). The residual itself may rise in
/// directions that are amplified, and says less. `None` where no share does.
pub(crate) fn damped<P: ZeroProblem>(
    problem: &mut P,
    r: f64,
    (z, step): (&DVector<f64>, &DVector<f64>),
    (mut share, least): (f64, f64),
    left: impl Fn(&Linearisation<P::Extra>) -> Option<f64>,
    most: impl Fn(f64) -> f64,
) -> Option<Damped<P::Extra>> {
    while share >= least {
        let tried = z + step * share;
        let there = problem.evaluate(&tried, r).ok();
        if let Some((left, at)) = there.and_then(|at| Some((left(&at)?, at)))
            && left <= most(share)
        {
            let z = tried;
            return Some(Damped { z, at, left, share });
        }
        share *= 0.5;
    }
    None
}

/// Unknowns at this r from which [`correct_at`](super::correct_at) leads to a solution, as far as the next correction tells;
/// `None` where damped steps lead to none.
pub(crate) fn approach<P: ZeroProblem>(
    problem: &mut P,
    mut z: DVector<f64>,
    r: f64,
) -> Option<DVector<f64>> {
    let scale = problem.scale();
    let mut at = problem.evaluate(&z, r).ok()?;
    let mut share = 1.0;
    for _ in 0..STEPS {
        let factors = at.scaled(&scale).lu();
        let next = |there: &Linearisation<P::Extra>| factors.solve(&-&there.residual);
        let step = next(&at)?;
        let size = step.norm();
        let went = damped(
            problem,
            r,
            (&z, &step.component_mul(&scale)),
            (share, LEAST),
            |there| Some(next(there)?.norm()),
            |share| (1.0 - 0.5 * share) * size,
        )?;
        if went.share == 1.0 && went.left <= CONTRACTS * size {
            return Some(went.z);
        }
        share = (2.0 * went.share).min(1.0);
        (z, at) = (went.z, went.at);
    }
    None
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use nalgebra::DMatrix;

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
