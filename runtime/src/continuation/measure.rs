//! The magnitude of the design variable in which steps are measured: one of the branch, not of how far it is followed.

use nalgebra::DVector;

/// Share, of the change in r that changes the unknowns by their own magnitude, in which a small r is measured.
const SHARE: f64 = 0.1;
/// How many times its own value r may be measured in.
const MOST: f64 = 4.0;
/// Share of r at the start of the branch below which it is not measured: enough to step over zero.
const LEAST: f64 = 0.1;

/// The magnitude of r where no tangent of a branch is known.
pub(crate) fn own_scale(r: f64) -> f64 {
    if r == 0.0 { 1.0 } else { r.abs() }
}

/// The magnitude of r at a point with this tangent, that being scaled by `r_scale`: r itself, but where r is small
/// against what it takes to change the unknowns, or against where the branch comes `from`, part of that. At a fold, where
/// the least change does, it is r. At zero, where what hardly changes at all would make it anything, it is no more than the
/// range from there `to` the end.
pub(super) fn at(r: f64, tangent: &DVector<f64>, r_scale: f64, [from, to]: [f64; 2]) -> f64 {
    let n = tangent.len() - 1;
    let effect = SHARE * r_scale * tangent[n].abs() / tangent.rows(0, n).norm();
    let usual = if r == 0.0 {
        effect.min((to - from).abs())
    } else {
        effect.max(r.abs()).min(MOST * r.abs())
    };
    let usual = usual.max(LEAST * from.abs());
    if usual.is_finite() && usual > 0.0 {
        usual
    } else {
        own_scale(r)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The tangent of unknowns that change at this rate.
    fn tangent(rate: f64, r_scale: f64) -> DVector<f64> {
        DVector::from_vec(vec![rate * r_scale, 1.0]).normalize()
    }

    #[test]
    fn r_is_measured_in_itself_where_it_matters() {
        assert_eq!(at(0.2, &tangent(3.0, 7.0), 7.0, [0.3, 1.0]), 0.2);
        assert_eq!(at(-0.2, &tangent(1e9, 7.0), 7.0, [0.0, -1.0]), 0.2);
        let fold = DVector::from_vec(vec![1.0, 0.0]);
        assert_eq!(at(0.2, &fold, 7.0, [0.0, 1.0]), 0.2);
    }

    #[test]
    fn a_branch_steps_over_zero() {
        let steep = tangent(1e9, 7.0);
        assert_eq!(at(1e-9, &steep, 7.0, [-0.5, 1.0]), LEAST * 0.5);
    }

    #[test]
    fn a_small_r_is_measured_in_what_it_changes() {
        assert!((at(0.0, &tangent(3.0, 7.0), 7.0, [0.0, 1.0]) - SHARE / 3.0).abs() < 1e-15);
        assert_eq!(at(1e-3, &tangent(3.0, 7.0), 7.0, [0.0, 1.0]), MOST * 1e-3);
        let indifferent = DVector::from_vec(vec![0.0, 1.0]);
        assert_eq!(at(0.0, &indifferent, 7.0, [0.0, 0.25]), 0.25);
        let hardly = tangent(1e-17, 7.0);
        assert_eq!(at(0.0, &hardly, 7.0, [0.0, 0.25]), 0.25);
    }
}
