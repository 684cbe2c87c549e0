//! Branches through where a state keeps still: that of others is as well known there as anywhere.

use stickslip::model;
use stickslip::study::OrbitRecord;
use stickslip_models::friction::Tustin;

use crate::borders::branch;

model! {
    /// A mass that a belt shakes, and another one that it drives.
    struct Driven {
        state x = 0.5;
        state v = 0.0;
        state y = 0.0;
        state w = 0.0;
        param couple = 1.0;
        friction F = Tustin { static_level: 1.0, kinetic_level: 0.5, speed: 1.0, viscous: 0.0 } opposing v - 0.5;
        der(x) = v;
        der(v) = F - x - 0.05 * v;
        der(y) = w;
        // What it is pressed by leaves it where it is, but for rounding errors.
        der(w) = (1e4 - 2.3 * y) - 1e4 - 0.2 * w + couple * x;
    }
}

/// What it drives swings by as much as the coupling is: through none, where its digits are all of rounding.
#[test]
fn a_branch_goes_through_where_a_state_keeps_still() {
    for accuracy in [1e-5, 1e-7, 1e-9] {
        let found = branch(&[], Driven::couple, (1.0, -0.8), |case| {
            case.accuracy = accuracy;
        });
        assert!(found.ended.reaches_bound(), "{}", found.ended.reason);
        assert!(found.special.is_empty() && found.points.len() < 60);
        let swing = |at: &OrbitRecord| at.max[2] - at.min[2];
        let [first, .., last] = found.points.as_slice() else {
            panic!("{} points", found.points.len());
        };
        let share = swing(last) / swing(first);
        assert!((share - 0.8).abs() < 100.0 * accuracy, "{share}");
        assert!((last.period / first.period - 1.0).abs() < 100.0 * accuracy);
    }
}
