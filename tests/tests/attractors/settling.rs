//! Motions that settle by little a turn, on orbits next to their flip.

use stickslip::bifurcation::Stability;
use stickslip::model;
use stickslip::study::{Case, Class, Dynamics, Sampling, System};
use stickslip_models::{BeltPair, systems};

use crate::shares::region;

model! {
    /// The unit circle, beside which u = p − x and w fall at the rates a and b in axes that turn half as fast: they come back
    /// with the multipliers −exp(−2πa) and −exp(−2πb). The cubic term makes them grow from u² = 8a/(3c) on.
    pub struct Twisted {
        state x = 1.0;
        state v = 0.0;
        state p = 1.08;
        state w = 0.0;
        param a = 2e-4;
        param b = 0.5;
        param c = 0.05;
        der(x) = x * (1.0 - powi(x, 2) - powi(v, 2)) - v;
        der(v) = v * (1.0 - powi(x, 2) - powi(v, 2)) + x;
        der(p) = x * (1.0 - powi(x, 2) - powi(v, 2)) - v - 0.5 * (a + b) * (p - x) + 0.5 * (b - a) * (-x * (p - x) - v * w)
            - 0.5 * w + c * powi(p - x, 3);
        der(w) = -0.5 * (a + b) * w + 0.5 * (b - a) * (x * w - v * (p - x)) + 0.5 * (p - x);
    }
}

/// The two-turn return of what swings to and fro is no better a guess than the orbit itself, and next to singular.
#[test]
fn what_swings_to_and_fro_settles_on_what_it_swings_about() {
    let system = System::of::<Twisted, _>();
    let case = Case::declared(system.info(), Dynamics::Smooth);
    let orbit = system.orbit(&case).unwrap();
    assert!(
        (orbit.period - std::f64::consts::TAU).abs() < 1e-8,
        "{orbit:?}"
    );
    let exact = -(-std::f64::consts::TAU * 2e-4).exp();
    assert!(
        (orbit.floquet.multipliers[0].re - exact).abs() < 1e-8,
        "{orbit:?}"
    );

    let system = systems::belt_pair();
    let mut case = Case::declared(system.info(), Dynamics::Exact);
    case.parameters[BeltPair::v_dr.index] = 0.16615384615384618;
    case.parameters[BeltPair::beta.index] = 1.3641025641025641;
    let usual = system.orbit(&case).unwrap();
    case.start = Some(vec![1.12551, 0.166153, 1.24732, 0.162710]);
    let orbit = system.orbit(&case).unwrap();
    assert_eq!(orbit.floquet.stability, Stability::Stable);
    assert!(
        (orbit.period / usual.period - 1.0).abs() < 1e-8,
        "{orbit:?}"
    );
}

/// The multiplier is −0.99775: its averages agree as those of a torus do.
#[test]
fn a_motion_that_settles_slowly_is_no_torus() {
    let system = systems::belt_pair();
    let mut case = Case::declared(system.info(), Dynamics::Exact);
    case.parameters[BeltPair::v_dr.index] = 0.14461538461538462;
    case.parameters[BeltPair::beta.index] = 1.3012820512820513;
    let sides = [("x1", -1.0, 1.0), ("x2", -1.0, 1.0)];
    let sampling = Sampling {
        areas: false,
        edges: false,
        ..Sampling::of(region(system.info(), &sides), 4)
    };
    let record = system.attractors(&case, &sampling).unwrap();
    let found = &record.surveys[0].found;
    let classes: Vec<Class> = found.iter().map(|one| one.attractor.class).collect();
    assert_eq!(classes, [Class::Orbit; 2], "{found:?}");
}
