//! Where orbits lose a symmetry, from whatever side.

use std::f64::consts::TAU;

use stickslip::continuation::Kind;
use stickslip::model;
use stickslip::study::{BranchRecord, Case, System};
use stickslip_models::friction::{Coulomb, CoulombStatic};
use stickslip_models::press::Compliant;

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

model! {
    /// A mass with an absorber that rubs, and swings between two stops.
    struct Absorber {
        state x: m = 0.0;
        state v: m/s = 0.0;
        state d: m = 0.0;
        state w: m/s = 0.0;
        param m: kg = 1.0 where m > 0.0;
        param k: N/m = 100.0 where k > 0.0;
        param c: N*s/m = 0.2 where c >= 0.0;
        param small: kg = 0.05 where small > 0.0;
        param ka: N/m = 4.5 where ka > 0.0;
        param gap: m = 0.05 where gap > 0.0;
        param stop: N/m = 2000.0 where stop > 0.0;
        param loss: N*s/m = 1.0 where loss >= 0.0;
        param mu: N = 0.05 where mu >= 0.0;
        param force: N = 0.5;
        param omega: rad/s = 8.0 where omega > 0.0;
        drive phi at omega;
        friction F: N = Coulomb { level: mu } opposing w;
        press A: N = Compliant { stiffness: stop, damping: loss } closing gap - d;
        press B: N = Compliant { stiffness: stop, damping: loss } closing gap + d;
        der(x) = v;
        der(v) = (force * cos(phi) - k * x - c * v + ka * d - F + A - B) / m;
        der(d) = w;
        der(w) = (-ka * d + F - A + B) / small - (force * cos(phi) - k * x - c * v + ka * d - F + A - B) / m;
    }
}

model! {
    /// A motor that turns a load to and fro through a joint with play, both rubbing.
    struct Play {
        state qm = 0.01;
        state wm = 0.0;
        state ql = 0.0;
        state wl = 0.0;
        param omega = 40.0 where omega > 0.0;
        drive phi at omega;
        let d = qm - ql;
        press P = Compliant { stiffness: 20.0, damping: 0.002 } closing 0.004 - d;
        press M = Compliant { stiffness: 20.0, damping: 0.002 } closing 0.004 + d;
        friction Fm = CoulombStatic { static_level: 0.03, kinetic_level: 0.02 } opposing wm;
        friction Fl = Coulomb { level: 0.01 } opposing wl;
        der(qm) = wm;
        der(ql) = wl;
        der(wm) = (0.1 * sin(phi) - P + M + Fm - 0.4 * qm) / 2.0e-4;
        der(wl) = (P - M + Fl - 2.0 * ql - 0.001 * wl) / 1.0e-3;
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

/// At borders that orbits meet on both sides at once, others begin that have lost their symmetry, and come back the other way
/// round: the branch stays with those that keep it. A pair of multipliers that is on the circle as far as their errors tell,
/// in the middle of a step or for several points, has passed it when it has left it.
#[test]
fn a_symmetric_branch_keeps_its_symmetry_at_borders() {
    use Kind::{
        CrossingSliding, Fold, GrazingSliding, SwitchingSliding, SymmetryBreaking, Torus,
        VanishingSegment,
    };
    // At 1e-10.
    let known = [
        (VanishingSegment, 8.033_800_56),
        (CrossingSliding, 8.290_408_314),
        (VanishingSegment, 8.394_842_21),
        (SymmetryBreaking, 8.394_923_073),
        (SymmetryBreaking, 9.077_383_870),
        (SymmetryBreaking, 9.421_204_257),
        (GrazingSliding, 9.500_771_604),
        (SwitchingSliding, 9.508_447_606),
        (CrossingSliding, 9.527_487_488),
        (SymmetryBreaking, 9.630_982_652),
        (SymmetryBreaking, 9.853_779_918),
        (CrossingSliding, 9.879_534_220),
        (SwitchingSliding, 9.888_464_330),
        (GrazingSliding, 9.891_845_279),
        (SymmetryBreaking, 10.029_027_09),
        (Torus, 11.146_821_34),
        (Fold, 11.965_479_95),
        (Torus, 11.950_727_24),
        (VanishingSegment, 11.496_352_5),
        (CrossingSliding, 12.050_347_26),
        (VanishingSegment, 13.481_299_6),
    ];
    for accuracy in [1e-7, 1e-8, 1e-9] {
        let absorber = Absorber {
            omega: 6.0,
            ..Absorber::default()
        };
        let mut case = Case::of(&absorber).following(Absorber::omega, 6.0..14.0);
        case.accuracy = accuracy;
        let branch = System::of::<Absorber, _>().branch(&case).unwrap();
        let reason = &branch.ended.reason;
        assert_eq!(branch.ended.word(), "reached-end", "{reason}");
        let kinds: Vec<Kind> = branch.special.iter().map(|one| one.kind).collect();
        assert_eq!(kinds, known.map(|(kind, _)| kind), "at {accuracy:e}");
        for (found, (kind, r)) in branch.special.iter().zip(known) {
            let (off, error) = ((found.r - r).abs(), found.error.unwrap());
            assert!(off <= error + 1e-7, "{kind:?} {off:e} {error:e}");
        }
    }
}

/// Orbits without the symmetry come to those that have it, and turn there into the images of themselves: a multiplier comes to 1
/// and goes back. It was told as a fold, or not at all.
#[test]
fn a_branch_turns_where_its_orbits_become_the_images_of_themselves() {
    let system = System::of::<Play, _>();
    let (from, to) = (40.0, 41.5);
    let along = |accuracy, range| {
        let mut case = Case::of(&Play::default()).following(Play::omega, range);
        case.accuracy = accuracy;
        case
    };
    // From the side of those that have it.
    let mut case = along(1e-9, to..from);
    case.parameters[Play::omega.index] = to;
    let whole = system.branch(&case).unwrap();
    let broken = |branch: &BranchRecord| {
        let mut all = branch.special.iter();
        all.find(|one| one.kind == Kind::SymmetryBreaking)
            .map(|one| one.r)
    };
    let right = broken(&whole).expect("a symmetry is lost");
    for accuracy in [1e-7, 1e-9] {
        let half = system.branch(&along(accuracy, from..to)).unwrap();
        let found = broken(&half).expect("the same place");
        assert!((found - right).abs() < 1e-8 * right, "{found} {right}");
        let folds = half.special.iter().filter(|one| one.kind == Kind::Fold);
        assert_eq!(folds.count(), 0, "{:?}", half.special);
    }
}
