//! Canards: orbits that change from small to large within the last digits of the design variable.

use stickslip::field::{Kernel, Smoothing};
use stickslip::model;
use stickslip::study::Dynamics;
use stickslip_models::DrillString;
use stickslip_models::friction::Gaussian;
use stickslip_tests::branches::{branch, named};

model! {
    /// A hydraulic cylinder at a low flow: a piston whose friction falls with its speed, and the pressure that moves it.
    struct Cylinder {
        state p: Pa = 1e5;
        state v: m/s = 0.0;
        param flow: m^3/s = 1e-6;
        friction F: N = Gaussian { static_level: 1200.0, kinetic_level: 700.0, speed: 0.005, viscous: 2000.0 } opposing v;
        der(p) = 1.4e12 * (flow - 1e-3 * v - 1e-14 * p);
        der(v) = (1e-3 * p + F) / 200.0;
    }
}

/// It reaches its end, with nothing told on the way: an orbit of two states that sticks has the multiplier 0, and no fold.
#[test]
fn a_canard_is_passed_from_small_orbits_to_large_ones() {
    let found = branch(&[], Cylinder::flow, (2.2e-7, 2.3e-7), |_| {});
    assert_eq!(found.ended.word(), "reached-end", "{}", found.ended.reason);
    assert!(found.special.is_empty(), "{:?}", named(&found));
    let within = found
        .points
        .iter()
        .filter(|row| 1.0 < row.period && row.period < 2.4);
    let steep: Vec<f64> = within.filter_map(|row| row.r).collect();
    assert!(steep.len() > 10, "{}", steep.len());
    for r in steep {
        // Where integrations of the motion after break-away (DOP853 of SciPy, rtol 1e-12) part, by halving.
        assert!((r / 2.275_665_182_501_66e-7 - 1.0).abs() < 1e-9, "{r}");
    }
}

/// A copy of the drill string whose layer is as wide as the table is fast: along its canard r does not tell orbits apart, and
/// they are not followed for ever.
#[test]
fn a_branch_that_stands_upright_ends() {
    let found = branch(&[], DrillString::eta, (0.12, 0.02), |case| {
        let (kernel, size) = (Kernel::Quartic, 0.1);
        case.dynamics = Dynamics::Smoothed(Smoothing { kernel, size });
    });
    assert_eq!(found.ended.word(), "step-too-small");
    let reason = &found.ended.reason;
    assert!(reason.contains("600 points in a row"), "{reason}");
    let upright = found.points.iter().rev().take(600);
    let values: Vec<f64> = upright.filter_map(|row| row.r).collect();
    assert!(values.iter().all(|r| (r / values[0] - 1.0).abs() < 1e-9));
}
