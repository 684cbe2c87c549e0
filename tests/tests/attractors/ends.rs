//! Where motions appear and vanish: by their shares, and by branches.

use stickslip::bifurcation::Kind;
use stickslip::field::Design;
use stickslip::study::{Along, Case, Class, Dynamics, System};

use crate::models::FrictionOscillator;
use crate::shares::sliding_from;

/// Places just beyond the belt's speed, from which the mass is caught.
const CAUGHT: [(&str, f64, f64); 2] = [("x", -0.01, 0.01), ("v", 1.99, 2.0)];

#[test]
fn the_cycle_ends_where_its_share_becomes_zero() {
    let (mut there, mut gone) = (1.775, 1.85);
    while gone - there > 1e-10 {
        let v_d = 0.5 * (there + gone);
        let found = sliding_from(v_d, &CAUGHT, (1, false), 1e-11).found;
        match found[0].attractor.class {
            // Within 1e-8 the mass is caught so softly that the orbit has no derivative.
            Class::Orbit | Class::Unsettled => there = v_d,
            Class::Equilibrium => gone = v_d,
            other => panic!("{v_d}: {other}"),
        }
    }
    let system = System::of::<FrictionOscillator, _>();
    let case = Case {
        along: Some(Along {
            design: Design::Parameter(FrictionOscillator::v_d.index),
            from: 1.5,
            to: 1.9,
        }),
        ..Case::declared(system.info(), Dynamics::Exact).at(1.5)
    };
    let branch = system.branch(&case).unwrap();
    let end = branch
        .special
        .iter()
        .find(|point| point.kind == Kind::GrazingSliding);
    assert!(
        (end.unwrap().r - there).abs() < 1e-9,
        "{} {there}",
        end.unwrap().r
    );
}

#[test]
fn steady_sliding_draws_motions_in_from_its_hopf_point_on() {
    // v₀ ln((μ_sd − 1) μ_d / (2 ξ v₀)): there friction falls with the speed as fast as the damper's force grows.
    let hopf = 0.5 * 10.0_f64.ln();
    let system = System::of::<FrictionOscillator, _>();
    let along = Along {
        design: Design::Parameter(FrictionOscillator::v_d.index),
        from: 1.0,
        to: 1.5,
    };
    let case = Case {
        along: Some(along),
        ..Case::declared(system.info(), Dynamics::Exact).at(1.0)
    };
    let branch = system.equilibria_along(&case).unwrap();
    let found = branch
        .special
        .iter()
        .find(|point| point.kind == Kind::Hopf)
        .unwrap();
    assert!((found.r - hopf).abs() < 1e-10, "{} {hopf}", found.r);
    let resting = |v_d: f64| {
        let near = [("x", 0.57, 0.63), ("v", -0.001, 0.001)];
        let found = sliding_from(v_d, &near, (4, false), 1e-9).found;
        found
            .iter()
            .any(|one| one.attractor.class == Class::Equilibrium)
    };
    assert!(!resting(hopf - 2e-3) && resting(hopf + 2e-2));
}

#[test]
#[ignore = "long"]
fn basins_have_areas_and_a_saddle_on_their_edge() {
    let sides = [("x", -2.0, 2.0), ("v", 0.0, 2.0)];
    let found = sliding_from(1.5, &sides, (400, true), 1e-9);
    let [cycle, rest] = [&found.found[0], &found.found[1]];
    let [area, error] = rest.area.unwrap();
    let [other, _] = cycle.area.unwrap();
    assert!(
        error < 1e-5 && (area + other - 1.0).abs() < 1e-6,
        "{area} {other} {error}"
    );
    assert!((area - 0.312).abs() < 3.0 * 0.0066, "{area}");
    // The branch of the cycle comes back as this saddle, from where it ends.
    let saddle = &found.edges[0].saddle;
    assert_eq!(
        (saddle.class, saddle.word.as_deref()),
        (Class::Orbit, Some("slip-(F)"))
    );
    assert!(
        (saddle.period.unwrap() - 6.295_334_79).abs() < 1e-7,
        "{saddle:?}"
    );
    assert!(
        (saddle.multipliers[0][0] - 1.4928).abs() < 1e-4,
        "{saddle:?}"
    );
}
