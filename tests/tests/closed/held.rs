//! Where friction begins and ceases to hold a mass all along an orbit, in closed form.

use std::f64::consts::TAU;

use stickslip::continuation::Kind;
use stickslip::model;
use stickslip::study::{BranchRecord, Case, Stability, System};
use stickslip_models::friction::Coulomb;
use stickslip_tests::bisected::bisected;

use crate::hartog::Hartog;

model! {
    /// A damped mass that is shaken, and by a spring pulls another one on rough ground.
    struct Pulled {
        state x: 1 = 1.0;
        state v: 1 = 0.0;
        state y: 1 = 1.0;
        state w: 1 = 0.0;
        param beta: 1 = 1.2 where beta > 0.0;
        param level: 1 = 0.5 where level >= 0.0;
        param force: 1 = 0.4;
        param damping: 1 = 0.05;
        drive phi at beta;
        friction F: 1 = Coulomb { level } opposing w;
        der(x) = v;
        der(v) = force * cos(phi) - 2.0 * x + y - damping * v;
        der(y) = w;
        der(w) = x - y + F;
    }
}

model! {
    /// Two masses on rough ground, one of which is shaken.
    struct Pair {
        state x: 1 = 1.0;
        state v: 1 = 0.0;
        state y: 1 = 1.0;
        state w: 1 = 0.0;
        param beta: 1 = 0.7 where beta > 0.0;
        param level: 1 = 0.4 where level >= 0.0;
        param damping: 1 = 0.05;
        drive phi at beta;
        friction F: 1 = Coulomb { level } opposing v;
        friction G: 1 = Coulomb { level: 1.5 * level } opposing w;
        der(x) = v;
        der(v) = cos(phi) - 2.0 * x + y - damping * v + F;
        der(y) = w;
        der(w) = x - 2.0 * y - damping * w + G;
    }
}

model! {
    /// A quarter of a car with a dry strut on a wavy road; nothing damps it where the strut holds.
    struct Quarter {
        state x: m = 0.01;
        state v: m/s = 0.0;
        state y: m = 0.01;
        state w: m/s = 0.0;
        param omega: rad/s = 30.0 where omega > 0.0;
        param wave: m = 0.001;
        param body: kg = 300.0;
        param wheel: kg = 40.0;
        param spring: N/m = 16000.0;
        param tyre: N/m = 160000.0;
        param damper: N*s/m = 600.0;
        param dry: N = 60.0;
        drive phi at omega;
        friction F: N = Coulomb { level: dry } opposing v - w;
        der(x) = v;
        der(v) = (-spring * (x - y) - damper * (v - w) + F) / body;
        der(y) = w;
        der(w) = (spring * (x - y) + damper * (v - w) - F - tyre * (y - wave * cos(phi))) / wheel;
    }
}

/// The branch lets go of what is held at r, within its error, and goes on to the end of its range.
#[track_caller]
fn lets_go(branch: &BranchRecord, r: f64) {
    let slip = branch.special.first().expect("it lets go");
    assert_eq!(slip.kind, Kind::VanishingSegment);
    let error = slip.error.expect("an estimate");
    assert!((slip.r - r).abs() <= error && error < 1e-6, "{slip:?}");
    assert_eq!(branch.ended.word(), "reached-end");
    let last = branch.points.last().unwrap();
    assert_ne!(last.word.as_deref(), Some("stick(F)"));
}

/// The branch passes into orbits that are held at r, within its error, and goes on to the end of its range.
#[track_caller]
fn comes_to_rest(branch: &BranchRecord, r: f64) {
    let rest = branch.special.last().expect("it comes to rest");
    assert_eq!(rest.kind, Kind::VanishingSegment);
    let error = rest.error.expect("an estimate");
    assert!((rest.r - r).abs() <= error && error < 1e-6, "{rest:?}");
    assert_eq!(branch.ended.word(), "reached-end");
    let last = branch.points.last().unwrap();
    assert_eq!(last.word.as_deref(), Some("stick(F)"));
}

/// Wherever it was held, the mass is followed in the middle, lets go where the force is more than friction, and slides beyond.
#[test]
fn a_mass_that_is_held_lets_go_where_friction_is_the_force() {
    let held = Hartog {
        level: 1.5,
        ..Hartog::default()
    };
    for place in [0.25, -0.1] {
        let case = Case {
            start: Some(vec![place, 0.0, 0.0]),
            ..Case::of(&held).following(Hartog::level, 1.5..0.5)
        };
        let branch = System::of::<Hartog, _>().branch(&case).unwrap();
        assert!(branch.points[0].max[0].abs() < 1e-12);
        lets_go(&branch, 1.0);
    }
}

/// What slides on one side of a point is held on the other, whichever way it is come to.
#[test]
fn masses_let_go_where_they_come_to_rest() {
    let pair = |level: f64| Pair {
        level,
        ..Pair::default()
    };
    let points = |from: f64, to: f64| {
        let case = Case::of(&pair(from)).following(Pair::level, from..to);
        let branch = System::of::<Pair, _>().branch(&case).unwrap();
        assert_eq!(branch.ended.word(), "reached-end");
        branch.special
    };
    let (rests, mut goes) = (points(0.4, 1.5), points(1.5, 0.4));
    goes.reverse();
    assert_eq!([rests.len(), goes.len()], [2, 2]);
    for (rests, goes) in rests.iter().zip(&goes) {
        let error = rests.error.unwrap() + goes.error.unwrap();
        assert!(
            (rests.r - goes.r).abs() <= error && error < 1e-7,
            "{rests:?} {goes:?}"
        );
    }
    // Both at rest, the first one bears the force alone.
    assert!(
        (goes[1].r - 1.0).abs() <= goes[1].error.unwrap(),
        "{:?}",
        goes[1]
    );
}

/// In the middle, where its slides lead it, the mass is held from F = 1 on.
#[test]
fn a_mass_comes_to_rest_where_friction_is_the_force() {
    let case = Case::of(&Hartog::default()).following(Hartog::level, 0.9..1.3);
    let branch = System::of::<Hartog, _>().branch(&case).unwrap();
    comes_to_rest(&branch, 1.0);
    assert_eq!(
        branch.points.last().unwrap().floquet.stability,
        Stability::Stable
    );
}

/// With the second mass at rest the first one swings by P/|2 − β² + icβ|, which is the force by which it pulls.
#[test]
fn a_mass_comes_to_rest_beyond_a_resonance() {
    let Pulled {
        level,
        force,
        damping,
        ..
    } = Pulled::default();
    let pull = |beta: f64| force / (2.0 - beta * beta).hypot(damping * beta);
    let rest = bisected(1.0, 1.2, |beta| pull(beta) - level);
    let case = Case::of(&Pulled::default()).following(Pulled::beta, 1.2..0.8);
    let branch = System::of::<Pulled, _>().branch(&case).unwrap();
    comes_to_rest(&branch, rest);
    let special = branch.special.last().unwrap();
    assert!((special.period * special.r / TAU - 1.0).abs() < 1e-12);
    let last = branch.points.last().unwrap();
    assert_eq!(last.floquet.stability, Stability::Stable);
    let swing = 0.5 * (last.max[0] - last.min[0]);
    assert!((swing / pull(0.8) - 1.0).abs() < 1e-9, "{swing}");
}

/// Locked, body and wheel swing as one by K/|K − (m + M) ω²| of the wave, and the strut bears M ω² times that. No motion
/// settles there.
#[test]
fn a_strut_comes_to_rest_on_a_smooth_road() {
    let Quarter {
        omega,
        body,
        wheel,
        tyre,
        dry,
        ..
    } = Quarter::default();
    let squared = omega * omega;
    let bears = body * squared * tyre / ((body + wheel) * squared - tyre);
    let case = Case::of(&Quarter::default()).following(Quarter::wave, 1e-3..1e-4);
    let branch = System::of::<Quarter, _>().branch(&case).unwrap();
    comes_to_rest(&branch, dry / bears);
}
