//! What decays much faster than all else moves, beside contacts.

use stickslip::model;
use stickslip::model::Model;
use stickslip::shooting::OrbitError;
use stickslip::study::{Case, Dynamics, StudyError, System};
use stickslip_models::friction::{Coulomb, CoulombStatic};

model! {
    /// A block that rides on a belt, and a gauge that follows it.
    pub struct Gauged {
        state x = 1.0;
        state v = 0.5;
        state q = 0.0;
        param belt = 0.5;
        param rate = 1e3 where rate > 0.0;
        friction F = Coulomb { level: 1.0 } opposing v - belt;
        der(x) = v;
        der(v) = F;
        der(q) = rate * (x - q);
    }
}

model! {
    /// A block that comes to rest on the ground, and a gauge that follows it.
    pub struct Stopped {
        state x = 1.0;
        state v = 0.0;
        state q = 0.0;
        param rate = 3e3 where rate > 0.0;
        friction F = Coulomb { level: 0.1 } opposing v;
        der(x) = v;
        der(v) = F - x;
        der(q) = rate * sinh(x - q);
    }
}

model! {
    /// A valve whose stem sticks, between a tank and a controller with integral action; SI units.
    pub struct Valve {
        state x = -0.003;
        state v = 0.0;
        state h = 0.006;
        state i = -0.56;
        param mass = 1.5 where mass > 0.0;
        param spring = 5e4 where spring > 0.0;
        friction F = CoulombStatic { static_level: 1000.0, kinetic_level: 700.0 } opposing v;
        der(x) = v;
        der(v) = (spring * (0.5 * (i / 20.0 - h) - x) - 600.0 * v + F) / mass;
        der(h) = (2.0 * x - h) / 10.0;
        der(i) = -h;
    }
}

fn case<M: Model<N>, const N: usize>() -> (System, Case) {
    (
        System::of::<M, N>(),
        Case::declared(M::INFO, Dynamics::Exact),
    )
}

/// q = x − V/k (1 − e^(−k t)) − x₀ e^(−k t): once that has died away, steps are as long as nothing else turns.
#[test]
fn what_has_died_away_costs_nothing() {
    let (system, mut case) = case::<Gauged, 3>();
    let time = 50.0;
    for rate in [1e3, 1e6, 1e9, 1e12] {
        case.parameters[Gauged::rate.index] = rate;
        let motion = system.motion(&case, time).expect("a motion");
        let end = motion.states.last().expect("an end");
        let right = 1.0 + 0.5 * time - 0.5 / rate;
        assert!((end[2] - right).abs() < 1e-12 * right, "{} {right}", end[2]);
        assert!(motion.work.steps < 3000, "{rate}: {}", motion.work.steps);
    }
}

#[test]
fn what_takes_too_many_steps_says_how_many() {
    let (system, mut case) = case::<Stopped, 3>();
    case.parameters[Stopped::rate.index] = 1e9;
    let error = system.motion(&case, 50.0).expect_err("too stiff");
    let said = error.to_string();
    assert!(said.contains("steps of") && said.contains("e9"), "{said}");
}

/// A second method (Radau IIA of SciPy, with located events) has the period 415.2807228589.
#[test]
fn a_sticking_valve_hunts() {
    let (system, case) = case::<Valve, 4>();
    let orbit = system.orbit(&case).expect("an orbit");
    assert!(
        (orbit.period / 415.280_722_858_9 - 1.0).abs() < 1e-7,
        "{}",
        orbit.period
    );
    let word = orbit.word.as_deref();
    assert_eq!(word, Some("stick(F) slip-(F) stick(F) slip+(F)"));
}

/// The errors of steps at the edge of stability are no motion.
#[test]
fn what_sticks_for_good_is_told_as_rest() {
    let (system, case) = case::<Stopped, 3>();
    let Err(StudyError::Orbit(OrbitError::Equilibrium { .. })) = system.orbit(&case) else {
        panic!("it rests")
    };
}
