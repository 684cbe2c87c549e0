//! Orbits from a start and a period that are known to one or two digits.

use stickslip::field::{Kernel, Smoothing};
use stickslip::study::{Case, Dynamics};
use stickslip_models::systems;
use stickslip_tests::random::Random;

/// How far the start and the period that are given are off, in half extents and as a share.
const OFF: [f64; 2] = [0.1, 0.02];
/// Starts for each orbit.
const STARTS: usize = 10;
/// Of those most lead to the orbit: masses that should stick begin to slide, and let go too soon.
const FOUND: usize = 7;

#[test]
fn a_start_of_one_digit_leads_to_the_orbit_beside_it_or_to_none() {
    let copy = Smoothing {
        kernel: Kernel::Quintic,
        size: 1e3,
    };
    let pair = systems::belt_pair;
    let asked = [
        (systems::belt_oscillator(), Dynamics::Exact),
        (pair(), Dynamics::Exact),
        (systems::drill_string(), Dynamics::Exact),
        (pair(), Dynamics::Smoothed(copy)),
    ];
    let mut dice = Random::new(5);
    for (system, dynamics) in asked {
        let case = Case::declared(system.info(), dynamics);
        let orbit = system.orbit(&case).expect("an orbit");
        let mut found = 0;
        for _ in 0..STARTS {
            let half = |j: usize| 0.5 * (orbit.max[j] - orbit.min[j]);
            let off = |j: usize, dice: &mut Random| OFF[0] * half(j) * dice.between(-1.0, 1.0);
            let near = (0..orbit.state.len()).map(|j| orbit.state[j] + off(j, &mut dice));
            let near = Case {
                start: Some(near.collect()),
                period: Some(orbit.period * (1.0 + OFF[1] * dice.between(-1.0, 1.0))),
                ..case.clone()
            };
            let Ok(other) = system.orbit(&near) else {
                continue;
            };
            let off = (other.period / orbit.period - 1.0).abs();
            let doubt = other.error_estimate + orbit.error_estimate;
            assert!(off <= doubt, "{}: {near:?}: {off:e}", system.info().command);
            found += 1;
        }
        assert!(found >= FOUND, "{}: {found}", system.info().command);
    }
}
