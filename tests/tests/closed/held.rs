//! Where friction begins and ceases to hold a mass all along an orbit, in closed form.

use stickslip::continuation::{Ending, Kind, Stop};
use stickslip::flow::FlowError;
use stickslip::model;
use stickslip::study::{BranchRecord, Case, Stability, System};
use stickslip_models::friction::Coulomb;

use crate::hartog::{Hartog, bisected};

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

/// The branch passes into orbits that are held at r, within its error, and goes on to the end of its range.
#[track_caller]
fn comes_to_rest(branch: &BranchRecord, r: f64) {
    let rest = branch.special.last().expect("it comes to rest");
    assert_eq!(rest.kind, Kind::VanishingSegment);
    let error = rest.error.expect("an estimate");
    assert!((rest.r - r).abs() <= error && error < 1e-5, "{rest:?}");
    assert_eq!(branch.ended.word(), "reached-end");
    let last = branch.points.last().unwrap();
    assert_eq!(last.word.as_deref(), Some("stick(F)"));
    assert_eq!(last.floquet.stability, Stability::Stable);
}

/// Held at x, the mass lets go where the spring and the force are more than friction: |x| + 1 = F.
#[test]
fn an_orbit_that_is_held_ends_where_friction_lets_go() {
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
        let last = branch.points.last().unwrap();
        assert!((last.max[0] - place).abs() < 1e-12, "{:?}", last.max);
        let off = last.r.unwrap() - (1.0 + place.abs());
        assert!(off.abs() < 1e-6, "{off:e}");
        assert!(branch.special.is_empty());
        let why = &branch.ended.ending;
        assert_eq!(*why, Ending::Stopped(Stop::Refused(FlowError::LetsGo)));
        assert!(branch.ended.is_located());
    }
}

/// In the middle, where its slides lead it, the mass is held from F = 1 on.
#[test]
fn a_mass_comes_to_rest_where_friction_is_the_force() {
    let case = Case::of(&Hartog::default()).following(Hartog::level, 0.9..1.3);
    let branch = System::of::<Hartog, _>().branch(&case).unwrap();
    comes_to_rest(&branch, 1.0);
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
    let last = branch.points.last().unwrap();
    let swing = 0.5 * (last.max[0] - last.min[0]);
    assert!((swing / pull(0.8) - 1.0).abs() < 1e-9, "{swing}");
}
