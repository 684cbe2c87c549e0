//! Borders of orbits along which another contact sticks all along: where that does so is free.

use stickslip::continuation::Kind;
use stickslip::model;
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
