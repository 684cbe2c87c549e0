//! What has turned over before it settles: on what it does so is one motion, however often that was.

use std::f64::consts::TAU;

use stickslip::model;
use stickslip::study::{Case, Class, Dynamics, Sampling, System};
use stickslip_models::friction::CoulombStatic;

use crate::shares::{region, survey};

model! {
    /// A pendulum with a dry hinge, the pivot of which is shaken upright twice as fast as it swings.
    pub struct Shaken {
        state a: rad = 0.5;
        state w: rad/s = 0.0;
        param shake: 1/s^2 = 0.2;
        param dry: 1/s^2 = 0.02 where dry >= 0.0;
        drive phi at 2.0;
        friction M: 1/s^2 = CoulombStatic { static_level: 1.5 * dry, kinetic_level: dry } opposing w;
        der(a) = w;
        der(w) = M - (1.0 + shake * cos(phi)) * sin(a);
    }
}

model! {
    /// The same with a hinge that is oiled.
    pub struct Oiled {
        state a: rad = 0.5;
        state w: rad/s = 0.0;
        param shake: 1/s^2 = 0.4;
        param oil: 1/s = 0.1;
        drive phi at 2.0;
        der(a) = w;
        der(w) = -oil * w - (1.0 + shake * cos(phi)) * sin(a);
    }
}

/// Beside it the orbit by shooting from where it is declared to begin, which has not turned.
fn swings_once(system: &System, dynamics: Dynamics, [low, high]: [f64; 2], classes: &[Class]) {
    let sides = [("a", low, high), ("w", -0.8, 0.8)];
    let found = survey(system, &[], &sides, (60, false), 1e-9).found;
    let kinds: Vec<Class> = found.iter().map(|one| one.attractor.class).collect();
    assert_eq!(kinds, classes, "{found:?}");
    let swing = &found[0].attractor;
    let orbit = system.orbit(&Case::declared(system.info(), dynamics));
    let orbit = orbit.expect("an orbit");
    let period = swing.period.expect("a period");
    assert!((period / orbit.period - 1.0).abs() < 1e-8, "{swing:?}");
    // Each is told from one of the two turns that its drive makes meanwhile.
    let near = |point: &Vec<f64>| (point[0] - orbit.state[0]).abs() < 1e-6;
    assert!(swing.points.iter().any(near), "{swing:?} {orbit:?}");
    assert!(swing.min[0] > -0.5 * TAU && swing.max[0] < 0.5 * TAU);
}

#[test]
fn a_swing_is_one_motion_wherever_it_was_turned_to() {
    let (dry, oiled) = (System::of::<Shaken, _>(), System::of::<Oiled, _>());
    let classes = [Class::Orbit, Class::Sticking];
    swings_once(&dry, Dynamics::Exact, [-10.0, 10.0], &classes);
    swings_once(&oiled, Dynamics::Smooth, [-10.0, 10.0], &classes[..1]);
    // Where no start is at home, it is told from there all the same.
    swings_once(&oiled, Dynamics::Smooth, [20.0, 30.0], &classes[..1]);
}

/// Whole turns away there are no others.
#[test]
fn the_number_of_motions_does_not_depend_on_where_starts_lie() {
    let system = System::of::<Shaken, _>();
    let case = Case::declared(system.info(), Dynamics::Exact);
    let count = |low: f64| {
        let sides = [("a", low, low + 6.0), ("w", -0.5, 0.5)];
        let sampling = Sampling::of(region(system.info(), &sides), 40);
        let record = system.attractors(&case, &sampling).expect("a survey");
        record.surveys[0].found.len()
    };
    assert_eq!(count(-3.0), count(-3.0 + 7.0 * TAU));
}
