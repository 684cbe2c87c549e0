//! Branches that end where their orbits come to one that leaves an equilibrium and comes back to it.

use stickslip::continuation::Ending;
use stickslip::model;
use stickslip::study::{BranchRecord, Dynamics};
use stickslip_models::friction::Coulomb;
use stickslip_tests::branches::{branch, named};

model! {
    /// Between two wells and around them, orbits keep to the energy m − 1: that of the saddle between them where m is 1.
    struct Wells {
        state x = 1.2;
        state y = 0.0;
        param m = 0.8;
        der(x) = y;
        der(y) = x - powi(x, 3) + y * (m - 1.0 - powi(y, 2) / 2.0 + powi(x, 2) / 2.0 - powi(x, 4) / 4.0);
    }
}

model! {
    /// A pendulum that a constant torque turns around.
    struct Turner {
        state angle = 0.0;
        state speed = 2.0;
        param torque = 0.6;
        param grip = 0.1 where grip >= 0.0;
        friction M = Coulomb { level: grip } opposing speed;
        der(angle) = speed;
        der(speed) = torque + M - 0.1 * speed - sin(angle);
    }
}

/// Where the branch says that its orbits come to a saddle.
fn homoclinic(found: &BranchRecord) -> f64 {
    let Ending::Homoclinic(at) = found.ended.ending else {
        panic!("{} {:?}", found.ended.reason, named(found));
    };
    assert!(found.ended.is_located());
    at
}

/// From within a well and from around both the orbits come to those that leave the saddle and come back to it.
#[test]
fn an_orbit_that_comes_to_a_saddle_lasts_without_bound() {
    for (range, x, accuracy) in [
        ((0.8, 1.2), 1.2, 1e-7),
        ((0.8, 1.2), 1.2, 1e-9),
        ((1.5, 0.8), 1.8, 1e-9),
    ] {
        let found = branch(&[], Wells::m, range, |case| {
            case.dynamics = Dynamics::Smooth;
            case.start = Some(vec![x, 0.0]);
            case.accuracy = accuracy;
        });
        let m = homoclinic(&found);
        assert!((m - 1.0).abs() < 2e-6, "{m}");
    }
}

/// While it turns one way, dry friction takes as much from the torque: it comes to rest where it would without, at so much more.
/// There it would stick, next to a saddle of sliding that is none of the motion.
#[test]
fn a_saddle_of_sliding_is_one_where_the_motion_would_stick() {
    let ends = |grip: f64, accuracy: f64| {
        let range = (0.6 + grip, 0.05 + grip);
        homoclinic(&branch(
            &[(Turner::grip, grip)],
            Turner::torque,
            range,
            |case| {
                case.accuracy = accuracy;
            },
        ))
    };
    for accuracy in [1e-6, 1e-9] {
        let (free, rubs) = (ends(0.0, accuracy), ends(0.1, accuracy));
        // By a method of Runge and Kutta from both ends of the saddle's way; told to the digit in which orbits stand still.
        for torque in [free, rubs - 0.1] {
            let off = torque - 0.127_008_859_8;
            assert!(off.abs() < 5e-7, "{free} {rubs}");
        }
    }
}
