//! What is carried on and on: on what it settles does not depend on where it is.

use stickslip::model;
use stickslip::study::{Case, Class, Dynamics, System};
use stickslip_models::friction::Coulomb;

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
