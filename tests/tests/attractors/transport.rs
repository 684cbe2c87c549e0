//! What is carried on and on: on what it settles does not depend on where it is.

use std::f64::consts::TAU;

use stickslip::model;
use stickslip::study::{Case, Class, Dynamics, System};
use stickslip_models::friction::{Coulomb, CoulombStatic};

use crate::shares::survey;

model! {
    /// A part on a trough that shakes along a slanted line and presses it harder while it moves on.
    pub struct Carried {
        state x = 0.0;
        state v = 0.0;
        param throw = 0.4;
        param cot = 1.7;
        param mu = 0.4;
        drive phi at 1.0;
        friction F = Coulomb { level: mu * (1.0 - throw * sin(phi)) } opposing v - throw * cot * cos(phi);
        der(x) = v;
        der(v) = F;
    }
}

/// Starts that are followed to their end take a second each: each is known where its contact lets go.
#[test]
fn what_is_carried_on_is_known_wherever_it_is() {
    let system = System::of::<Carried, _>();
    let sides = [("x", -5.0, 5.0), ("v", -1.0, 1.0)];
    let found = survey(&system, &[], &sides, (300, false), 1e-9).found;
    let [one] = found.as_slice() else {
        panic!("{found:?}");
    };
    assert_eq!(one.attractor.class, Class::Running);
    // Beside it the orbit by shooting.
    let orbit = system.orbit(&Case::declared(system.info(), Dynamics::Exact));
    let gains = [orbit.expect("an orbit").shift, one.attractor.shift.clone()];
    let [expected, gain] = gains.map(|shift| shift.expect("a motion that runs on")[0]);
    assert!((gain - expected).abs() < 1e-7, "{gain} {expected}");
}

model! {
    /// A body on the ground that a spring tows in jerks: where it is, and how far the spring is stretched.
    pub struct Towed {
        state x: m = 0.0;
        state v: m/s = 0.0;
        state stretch: m = 0.0;
        param mass: kg = 1.0 where mass > 0.0;
        param k: N/m = 4.0 where k > 0.0;
        param pull: m/s = 0.1;
        param peak: N = 1.5 where peak > 0.0;
        param level: N = 1.0 where level > 0.0;
        friction F: N = CoulombStatic { static_level: peak, kinetic_level: level } opposing v;
        der(x) = v;
        der(v) = (k * stretch + F) / mass;
        der(stretch) = pull - v;
    }
}

/// From where it lets go, d = (peak − level)/k beyond where the spring balances friction, it swings about that at the rate
/// ω = √(k/m) until it is as slow as the pull again, d before it: (2π − 2 atan(d ω/pull))/ω; the pull takes 2d/pull from
/// there. It never goes back, so that where it is least is where some passage happens to begin while it rests.
#[test]
fn what_is_towed_in_jerks_is_known_wherever_it_begins() {
    let towed = Towed::default();
    let (d, rate) = (
        (towed.peak - towed.level) / towed.k,
        (towed.k / towed.mass).sqrt(),
    );
    let period = 2.0 * d / towed.pull + (TAU - 2.0 * (d * rate / towed.pull).atan()) / rate;
    let system = System::of::<Towed, _>();
    let case = Case::of(&towed);
    for start in [None, Some([0.0, 0.0, 0.3]), Some([3.0, 0.2, 0.1])] {
        let start = start.map(|start| start.to_vec());
        let orbit = system
            .orbit(&Case {
                start,
                ..case.clone()
            })
            .expect("an orbit");
        assert!(
            (orbit.period / period - 1.0).abs() < 1e-9,
            "{}",
            orbit.period
        );
        let gain = orbit.shift.expect("it runs on")[0];
        assert!((gain / (towed.pull * period) - 1.0).abs() < 1e-9, "{gain}");
    }
    // Nearer to the steady motion, those that never stick swing on as they began.
    let sides = [("x", -1.0, 1.0), ("v", 0.0, 0.05), ("stretch", 0.0, 0.1)];
    let found = survey(&system, &[], &sides, (100, false), 1e-9).found;
    let [one] = found.as_slice() else {
        panic!("{found:?}");
    };
    assert_eq!(one.attractor.class, Class::Running);
    let found = one.attractor.period.expect("a period");
    assert!((found / period - 1.0).abs() < 1e-7, "{found}");
}
