//! Unstable orbits beside what starts have found, against closed forms and against the saddle on the edge.

use std::f64::consts::TAU;

use stickslip::model;
use stickslip::study::{Attractor, Case, Class, Sampling, System, choose};

use crate::models::FrictionOscillator;
use crate::shares::region;

model! {
    /// A point that turns once in 2π and comes nearer to or further from the circles of radii 1, 1.7, 3 and 3.3.
    pub struct Circles {
        state x = 1.2;
        state y = 0.0;
        param c = 0.0001;
        let s = x * x + y * y;
        let rate = c * (s - 1.0) * (s - 2.89) * (s - 9.0) * (s - 10.89);
        der(x) = rate * x - y;
        der(y) = rate * y + x;
    }
}

/// ρ' at a circle over ρ − its radius: s = ρ² there, and of the other circles.
fn slope(s: f64, others: [f64; 3]) -> f64 {
    2.0 * 0.0001 * s * others.iter().map(|other| s - other).product::<f64>()
}

/// What starts in a region settle on, and what is found besides.
fn further(system: &System, set: &[f64], sides: &[(&str, f64, f64)]) -> [Vec<Attractor>; 2] {
    let info = system.info();
    let mut case = Case::declared(info, choose(info, None, 1e-9).dynamics);
    case.parameters[..set.len()].copy_from_slice(set);
    let sampling = Sampling {
        further: true,
        ..Sampling::of(region(info, sides), 40)
    };
    let mut found = system.attractors(&case, &sampling).unwrap();
    let survey = found.surveys.remove(0);
    let settled = survey.found.into_iter().map(|one| one.attractor);
    [settled.collect(), survey.further]
}

#[test]
fn circles_between_and_beyond_the_stable_ones_are_found() {
    let sides = [("x", -2.2, 2.2), ("y", -2.2, 2.2)];
    let [settled, mut found] = further(&System::of::<Circles, _>(), &[], &sides);
    assert_eq!(settled.len(), 2, "{settled:?}");
    found.sort_by(|a, b| a.max[0].total_cmp(&b.max[0]));
    let expected = [
        (1.7, slope(2.89, [1.0, 9.0, 10.89])),
        (3.3, slope(10.89, [1.0, 2.89, 9.0])),
    ];
    assert_eq!(found.len(), 2, "{found:?}");
    for (found, (radius, slope)) in found.iter().zip(expected) {
        assert!((found.max[0] - radius).abs() < 1e-8, "{found:?}");
        assert!((found.period.unwrap() - TAU).abs() < 1e-8, "{found:?}");
        let growth = (TAU * slope).exp();
        assert!(
            (found.multipliers[0][0] / growth - 1.0).abs() < 1e-6,
            "{growth}: {found:?}"
        );
    }
}

#[test]
fn the_saddle_of_steady_sliding_is_found_without_its_edge() {
    let sides = [("x", -2.0, 2.0), ("v", 0.0, 2.0)];
    let [_, found] = further(&System::of::<FrictionOscillator, _>(), &[1.5], &sides);
    // The saddle on the edge, to which bisection leads.
    let [saddle] = found.as_slice() else {
        panic!("{found:?}");
    };
    assert_eq!(
        (saddle.class, saddle.word.as_deref()),
        (Class::Orbit, Some("slip-(F)"))
    );
    assert!((saddle.period.unwrap() - 6.295_334_79).abs() < 1e-7);
    assert!((saddle.multipliers[0][0] - 1.4928).abs() < 1e-4);
}
