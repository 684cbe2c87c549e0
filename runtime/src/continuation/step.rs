//! The step size along a branch, and the guards on the angle between tangent and chord.

use nalgebra::DVector;

/// Contraction of Newton's corrections at which the step is just right.
const CONTRACTION: f64 = 0.02;
/// Angle between tangent and chord at which the step is just right.
const BEND: f64 = 0.12;
const SHRINK: f64 = 0.25;
const GROW: f64 = 2.5;

/// Angles (2.21) and (2.22) between the tangent and the chord, in scaled coordinates with r last.
pub(super) fn angles(tangent: &DVector<f64>, chord: &DVector<f64>) -> (f64, f64) {
    let n = tangent.len() - 1;
    let full = angle(tangent, chord);
    let unknowns = angle(
        &tangent.rows(0, n).into_owned(),
        &chord.rows(0, n).into_owned(),
    );
    (full, unknowns)
}

/// The angle between two directions, 0 where one of them vanishes.
fn angle(a: &DVector<f64>, b: &DVector<f64>) -> f64 {
    let lengths = a.norm() * b.norm();
    // A solution that does not depend on r has no direction to lose.
    if lengths <= 1e-14 {
        return 0.0;
    }
    (a.dot(b) / lengths).clamp(-1.0, 1.0).acos()
}

/// The factor by which the next step may be longer: from the ratio of successive corrections and the bend.
pub(super) fn growth(corrections: &[f64], bend: f64) -> f64 {
    let contraction = match corrections {
        [first, second, ..] if *first > 0.0 => second / first,
        _ => 0.0,
    };
    let by_newton = (CONTRACTION / contraction.max(1e-12)).sqrt();
    let by_bend = BEND / bend.max(1e-12);
    by_newton.min(by_bend).clamp(SHRINK, GROW)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_leave_out_the_design_variable() {
        let tangent = DVector::from_vec(vec![1.0, 0.0, 1.0]);
        let chord = DVector::from_vec(vec![1.0, 0.0, 0.0]);
        let (full, unknowns) = angles(&tangent, &chord);
        assert!((full - std::f64::consts::FRAC_PI_4).abs() < 1e-15);
        assert_eq!(unknowns, 0.0);
    }

    #[test]
    fn an_indifferent_solution_has_no_angle() {
        let tangent = DVector::from_vec(vec![0.0, 1.0]);
        assert_eq!(angles(&tangent, &tangent).1, 0.0);
    }

    #[test]
    fn easy_steps_grow_and_hard_ones_shrink() {
        assert_eq!(growth(&[1e-3, 1e-9], 1e-3), GROW);
        assert_eq!(
            growth(&[1e-3, 9e-4], 1e-3),
            SHRINK.max((CONTRACTION / 0.9_f64).sqrt())
        );
    }
}
