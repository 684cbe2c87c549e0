//! Where orbits lose a symmetry, from whatever side.

use std::f64::consts::TAU;

use stickslip::continuation::Kind;
use stickslip::model;
use stickslip::study::{BranchRecord, Case, System};

model! {
    /// A driven pendulum: x ↦ −x after half a turn of the drive.
    struct Pendulum {
        state x = 0.0;
        state v = 0.0;
        param load = 1.0;
        param omega = 0.9 where omega > 0.0;
        drive phi at omega;
        der(x) = v;
        der(v) = load * cos(phi) - sin(x) - 0.5 * v;
    }
}

fn followed(case: &Case) -> BranchRecord {
    System::of::<Pendulum, _>().branch(case).unwrap()
}

fn broken(branch: &BranchRecord) -> f64 {
    let kinds: Vec<Kind> = branch.special.iter().map(|one| one.kind).collect();
    assert_eq!(kinds, [Kind::SymmetryBreaking], "{:?}", branch.ended.reason);
    branch.special[0].r
}

/// There det(1 + M) of the half-period map M = −∂φ(T/2) vanishes, by Runge and Kutta's method.
///
/// The orbit that swings as far to both sides loses its symmetry on the way down; from there it is come to again.
#[test]
fn a_symmetry_is_lost_at_one_place_from_either_side() {
    for accuracy in [1e-7, 1e-9, 1e-10] {
        let mut case = Case::of(&Pendulum::default()).following(Pendulum::omega, 0.9..0.6);
        case.accuracy = accuracy;
        let there = followed(&case);
        let last = there.points.last().unwrap();
        let mut case = case.following(Pendulum::omega, 0.6..0.9);
        case.parameters[Pendulum::omega.index] = 0.6;
        (case.start, case.period) = (Some(last.state.clone()), Some(last.period));
        let back = followed(&case);
        for branch in [there, back] {
            let off = (broken(&branch) - 0.6643218744).abs();
            assert!(off < accuracy.max(2e-10), "{off:e} {accuracy}");
            let (r, period) = (branch.special[0].r, branch.special[0].period);
            assert!((period * r / TAU - 1.0).abs() < 1e-14, "{period} at {r}");
        }
    }
}

/// What was saved where the symmetry is lost begins a branch as well: next to there, as its equations are singular.
#[test]
fn a_branch_begins_where_the_symmetry_is_lost() {
    let case = Case::of(&Pendulum::default()).following(Pendulum::omega, 0.9..0.6);
    let lost = followed(&case).special[0].clone();
    for to in [0.6, 0.9] {
        let mut case = case.clone().following(Pendulum::omega, lost.r..to);
        case.parameters[Pendulum::omega.index] = lost.r;
        (case.start, case.period) = (Some(lost.state.clone()), Some(lost.period));
        let branch = followed(&case);
        assert_eq!(branch.ended.word(), "reached-end");
        let r = |k: usize| branch.points[k].r.unwrap_or(f64::NAN);
        let aside = (r(0) - lost.r) / (to - lost.r);
        assert!(0.0 < aside && aside <= 1e-3, "{aside}");
        for (k, point) in branch.points.iter().enumerate() {
            let lean = (point.max[0] + point.min[0]) / point.max[0];
            assert!(lean.abs() < 1e-6, "{lean:e} at {}", r(k));
        }
    }
}
