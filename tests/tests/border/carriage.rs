//! Bodies that friction moves on over fixed ground: where their motion begins, and where two laps become one.

use stickslip::continuation::Kind;
use stickslip::model;
use stickslip::study::BranchRecord;
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Compliant;
use stickslip_tests::branches::{branch, named};

model! {
    /// Two bodies joined by a spring, pushed apart in turn over ground that holds the second one more.
    struct Creeper {
        state x = 0.0;
        state u = 0.3;
        state y = 0.0;
        state w = 0.0;
        param push = 0.5;
        param level = 0.2 where level > 0.0;
        drive phi at 1.3;
        friction F = Coulomb { level } opposing u;
        friction G = Coulomb { level: 1.7 * level } opposing w;
        let force = y - x + 0.1 * (w - u) + push * sin(phi);
        der(x) = u;
        der(u) = force + F;
        der(y) = w;
        der(w) = G - force;
    }
}

model! {
    /// A capsule that a mass inside drives over dry ground, after Liu, Wiercigroch, Pavlovskaia and Yu, International Journal of
    /// Mechanical Sciences 66, 2013.
    struct Capsule {
        state x = 0.0;
        state v = 0.0;
        state capsule = 0.0;
        state u = 0.0;
        param alpha = 1.2;
        drive phi at 0.95;
        friction F = Coulomb { level: 1.0 } opposing u;
        press N = Compliant { stiffness: 15.0, damping: 0.0 } closing 0.02 - (x - capsule);
        let spring = x - capsule + 0.02 * (v - u);
        der(x) = v;
        der(v) = alpha * cos(phi) - spring - N;
        der(capsule) = u;
        der(u) = (spring + N + F) / 5.0;
    }
}

/// Both held by one spring, one of the two contacts is told by the other: with no preload between them, the first lets go where
/// the push is what it can bear, at 0.2, whichever way that is come to. Beyond, the second keeps still to its rounding errors,
/// which are no measure of it.
#[test]
fn motion_begins_where_the_push_is_what_friction_bears() {
    let up = branch(&[], Creeper::push, (0.1, 1.0), |_| {});
    let down = branch(&[], Creeper::push, (1.0, 0.1), |_| {});
    for found in [&up, &down] {
        assert_eq!(found.ended.word(), "reached-end", "{}", found.ended.reason);
        let begins = found.special.iter().find(|one| (one.r - 0.2).abs() < 1e-8);
        assert!(begins.is_some(), "{:?}", named(found));
    }
    let part = branch(&[], Creeper::push, (0.21, 1.0), |_| {});
    assert_eq!(part.ended.word(), "reached-end", "{}", part.ended.reason);
    let beyond = |found: &BranchRecord| -> Vec<f64> {
        let values = found.special.iter().map(|one| one.r);
        let mut values: Vec<f64> = values.filter(|r| *r > 0.21).collect();
        values.sort_by(f64::total_cmp);
        values
    };
    for found in [&down, &part] {
        let mut pairs = beyond(&up).into_iter().zip(beyond(found));
        assert_eq!(beyond(&up).len(), beyond(found).len());
        assert!(pairs.all(|(a, b)| (a - b).abs() < 1e-7));
    }
}

/// An orbit of six turns of the drive becomes one of three there, at which that has its flip; one step leads past it, to
/// orbits that begin half a lap later.
#[test]
fn two_laps_become_one_where_the_shorter_orbit_doubles() {
    let doubled = branch(&[], Capsule::alpha, (0.8, 1.6), |_| {});
    let single = branch(&[], Capsule::alpha, (1.2, 0.84), |_| {});
    let flips = [&doubled, &single].map(|found| {
        let flip = found.special.iter().find(|one| one.kind == Kind::Flip);
        flip.map(|one| one.r)
            .unwrap_or_else(|| panic!("{:?}, {}", named(found), found.ended.reason))
    });
    assert!((flips[0] - flips[1]).abs() < 1e-9, "{flips:?}");
    assert_eq!(doubled.special.last().map(|one| one.kind), Some(Kind::Flip));
}
