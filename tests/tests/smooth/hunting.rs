//! A servo that hunts: bristles that bend as they hold, and let go at once.

use stickslip::model;
use stickslip::study::{Case, System};
use stickslip_models::friction::LuGre;

model! {
    /// A position that is controlled in proportion, by its integral and by its rate, after Canudas de Wit, Olsson, Åström and
    /// Lischinsky, IEEE Transactions on Automatic Control 40, 1995.
    struct Servo {
        state x = 0.0;
        state v = 0.0;
        state z = 0.0;
        state e = 0.0;
        param ki = 4.0;
        friction F = LuGre { stiffness: 1e5, damping: 316.0, viscous: 0.4, kinetic: 1.0, peak: 1.5, stribeck: 0.001 }
            opposing v with z;
        der(x) = v;
        der(v) = 3.0 * (1.0 - x) + ki * e - 6.0 * v + F;
        der(e) = 1.0 - x;
    }
}

/// What the integrator errs by, the motion that breaks away makes a hundred times as much, more than Newton's method bears: the
/// orbit is known, and its branch is begun with a finer tolerance.
#[test]
fn the_branch_of_an_orbit_whose_errors_grow_is_begun_more_sharply() {
    let system = System::of::<Servo, _>();
    let case = Case::of(&Servo::default()).following(Servo::ki, 4.0..1.0);
    let branch = system.branch(&case).unwrap();
    assert_eq!(
        branch.ended.word(),
        "reached-end",
        "{}",
        branch.ended.reason
    );
    let last = branch.points.last().unwrap();
    let there = Servo { ki: 1.0 };
    let alone = system.orbit(&Case::of(&there)).unwrap();
    let off = (last.period / alone.period - 1.0).abs();
    assert!(off < 1e-7, "{} and {}", last.period, alone.period);
}
