//! Borders of orbits along which another contact sticks all along: where that does so is free.

use stickslip::bifurcation::Stability;
use stickslip::continuation::Kind;
use stickslip::model;
use stickslip::model::Model;
use stickslip::study::{BranchRecord, Case, Special, System};
use stickslip_models::friction::{Coulomb, Tustin};

model! {
    /// A brake whose load sways, and a shoe that it carries along unless friction holds it.
    struct Shoe {
        state a = 0.0;
        state w = 0.0;
        state s = 0.0;
        state q = 0.0;
        param turning = 1.0;
        drive phi at 3.0;
        let load = 1.0 + 0.3 * cos(phi);
        friction F = Tustin { static_level: 1.2 * load, kinetic_level: 0.8 * load, speed: 0.2, viscous: 0.0 } opposing w - turning;
        friction G = Coulomb { level: 0.2 } opposing q;
        der(a) = w;
        der(w) = F - 5.0 * a - 0.1 * w + s;
        der(s) = q;
        der(q) = (a + G - 4.0 * s) / 0.3;
    }
}

model! {
    /// The same with the shoe in one place.
    struct Fixed {
        state a = 0.0;
        state w = 0.0;
        param turning = 0.3;
        param s = 0.05;
        drive phi at 3.0;
        let load = 1.0 + 0.3 * cos(phi);
        friction F = Tustin { static_level: 1.2 * load, kinetic_level: 0.8 * load, speed: 0.2, viscous: 0.0 } opposing w - turning;
        der(a) = w;
        der(w) = F - 5.0 * a - 0.1 * w + s;
    }
}

model! {
    /// Four blocks in a row over ground, the first of which is driven.
    struct Train {
        state x[4] = 0.0;
        state v[4] = 0.0;
        param level = 1.0 where level >= 0.0;
        param push = 6.0;
        drive phi at 5.0;
        friction F0 = Coulomb { level } opposing v[0];
        friction F1 = Coulomb { level: 1.3 * level } opposing v[1];
        friction F2 = Coulomb { level: 1.7 * level } opposing v[2];
        friction F3 = Coulomb { level: 2.1 * level } opposing v[3];
        let first = 100.0 * (x[1] - x[0]) + 0.5 * (v[1] - v[0]);
        let second = 100.0 * (x[2] - x[1]) + 0.5 * (v[2] - v[1]);
        let third = 100.0 * (x[3] - x[2]) + 0.5 * (v[3] - v[2]);
        der(x[0]) = v[0];
        der(x[1]) = v[1];
        der(x[2]) = v[2];
        der(x[3]) = v[3];
        der(v[0]) = F0 + push * cos(phi) - 20.0 * x[0] + first;
        der(v[1]) = F1 - 20.0 * x[1] - first + second;
        der(v[2]) = F2 - 20.0 * x[2] - second + third;
        der(v[3]) = F3 - 20.0 * x[3] - third;
    }
}

model! {
    /// A drum that hangs by two springs and two dampers that rub: an unbalance aside of its middle sways and turns it.
    struct Washer {
        state y: m = 0.0;
        state v: m/s = 0.0;
        state r: rad = 0.0;
        state w: rad/s = 0.0;
        param unbalance: kg*m = 0.1;
        param off: m = 0.1;
        param omega: rad/s = 15.0 where omega > 0.0;
        param left: N = 15.0 where left >= 0.0;
        param right: N = 20.0 where right >= 0.0;
        param m: kg = 40.0;
        param inertia: kg*m^2 = 2.0;
        param k: N/m = 4000.0;
        param c: N*s/m = 20.0;
        param arm: m = 0.25;
        drive phi at omega;
        friction F: N = Coulomb { level: left } opposing v + arm * w;
        friction G: N = Coulomb { level: right } opposing v - arm * w;
        let push = unbalance * omega * omega * cos(phi);
        der(y) = v;
        der(v) = (push - 2.0 * k * y - 2.0 * c * v + F + G) / m;
        der(r) = w;
        der(w) = (off * push - 2.0 * k * arm * arm * r - 2.0 * c * arm * arm * w + arm * F - arm * G) / inertia;
    }
}

/// Only the force over the levels counts: twice the force is half the levels. A branch ended where the second block let go, as
/// what had held it was not known to slide from the first, least orbit on.
#[test]
fn contacts_let_go_one_after_another() {
    let followed = |along, range| {
        let case = Case::of(&Train::default()).following(along, range);
        let branch = System::of::<Train, _>().branch(&case).unwrap();
        let reason = &branch.ended.reason;
        assert_eq!(branch.ended.word(), "reached-end", "{reason}");
        branch.special
    };
    let pushed = followed(Train::push, 0.5..4.0);
    let levels = followed(Train::level, 12.0..1.5);
    assert_eq!(pushed.len(), levels.len(), "{pushed:?} {levels:?}");
    for (push, level) in pushed.iter().zip(&levels) {
        assert_eq!(push.kind, level.kind);
        let [off, error] = [push, level].map(|one| one.error.unwrap() / one.r);
        let off = off + error;
        let apart = (push.r * level.r / 6.0 - 1.0).abs();
        assert!(apart <= off, "{} {}: {apart:e} {off:e}", push.r, level.r);
    }
    // The first block begins where the force is its friction, and as it hardly moves the others do not.
    assert!((pushed[0].r - 1.0).abs() < 1e-7, "{}", pushed[0].r);
    // Back again, they come to rest where they let go, and pass the same on the way to there.
    let back = followed(Train::push, 4.0..0.5);
    assert_eq!(pushed.len(), back.len(), "{pushed:?} {back:?}");
    for (push, back) in pushed.iter().zip(back.iter().rev()) {
        let near = (back.r - push.r).abs() < 1e-5 * push.r;
        assert!(near && back.kind == push.kind, "{} {}", push.r, back.r);
    }
}

/// A branch may begin where its parameter is zero, and where it changes nothing before friction lets go: F bears (1 + off/arm)/2 of
/// the unbalance ω², which is `left` at 1/12. It was told that friction lets go, and nothing else.
#[test]
fn a_branch_begins_at_zero_where_nothing_changes() {
    let case = Case::of(&Washer::default()).following(Washer::off, 0.0..0.25);
    let case = Case {
        parameters: Washer {
            off: 0.0,
            ..Washer::default()
        }
        .values()
        .as_ref()
        .to_vec(),
        ..case
    };
    let branch = System::of::<Washer, _>().branch(&case).unwrap();
    let found: Vec<(Kind, f64)> = branch.special.iter().map(|one| (one.kind, one.r)).collect();
    assert_eq!(branch.ended.word(), "reached-end", "{found:?}");
    let [(Kind::VanishingSegment, slips), (Kind::CrossingSliding, _)] = found[..] else {
        panic!("{found:?}")
    };
    assert!((slips - 1.0 / 12.0).abs() < 1e-9, "{slips}");
    let work = branch.points.iter().map(|one| one.work.newton);
    assert!(
        work.clone().all(|newton| newton < 10_000),
        "{:?}",
        work.collect::<Vec<_>>()
    );
}

/// Where friction comes to hold a contact in any of many places, the last orbit along which it slides is not the one on which the
/// motion settles.
#[test]
fn a_motion_settles_where_friction_holds_it() {
    let settled = Washer {
        omega: 30.0,
        ..Washer::default()
    };
    let orbit = System::of::<Washer, _>()
        .orbit(&Case::of(&settled))
        .unwrap();
    assert_eq!(orbit.word.as_deref(), Some("slip-(F) slip+(F)"));
    assert_eq!(orbit.floquet.stability, Stability::Stable);
    assert!(orbit.error_estimate < 1e-9, "{:e}", orbit.error_estimate);
}

/// It was told by a bracket at best, or the branch ended there.
#[test]
fn a_graze_is_found_while_another_contact_sticks() {
    for accuracy in [1e-7, 1e-9, 1e-11] {
        let mut case = Case::of(&Shoe::default()).following(Shoe::turning, 1.0..0.1);
        case.accuracy = accuracy;
        let held = System::of::<Shoe, _>().branch(&case).unwrap();
        let found = graze(&held);
        let error = found.error.expect("an error");
        assert!(error <= accuracy, "{error:e} at {accuracy:e}");
        // From a little before it, with the shoe where it stands at the graze.
        let mut before = held.points.iter();
        let orbit = before.rfind(|one| one.r > Some(1.01 * found.r)).unwrap();
        let [a, w, s, _, phi] = orbit.state[..] else {
            panic!("{:?}", orbit.state)
        };
        let fixed = Fixed {
            s: found.state[2],
            ..Fixed::default()
        };
        let case = Case {
            start: Some(vec![a, w, phi]),
            period: Some(orbit.period),
            accuracy: 1e-11,
            ..Case::of(&fixed).following(Fixed::turning, orbit.r.unwrap()..0.1)
        };
        let fixed = System::of::<Fixed, _>().branch(&case).unwrap();
        let off = (graze(&fixed).r - found.r).abs();
        assert!(off <= error + 1e-11, "{off:e} {error:e} at {accuracy:e}");
        assert!((s / found.state[2] - 1.0).abs() > 1e-4, "it moves");
    }
}

/// The graze of a branch that has one, and goes to its end.
fn graze(branch: &BranchRecord) -> &Special {
    let reason = &branch.ended.reason;
    assert_eq!(branch.ended.word(), "reached-end", "{reason}");
    let mut special = branch.special.iter();
    let graze = special.find(|one| one.kind == Kind::GrazingSliding);
    graze.unwrap_or_else(|| panic!("{:?}", branch.special))
}
