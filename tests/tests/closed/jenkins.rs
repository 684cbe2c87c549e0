//! What one Jenkins element dissipates in a cycle.

use std::f64::consts::TAU;

use stickslip::model;
use stickslip::study::{Case, System};
use stickslip_models::friction::Jenkins;

model! {
    /// A contact of stiffness k that is moved to and fro by u = U sin φ, and slips at F.
    struct Moved {
        state loss: J = 0.0;
        state z: N = 0.0;
        param k: N/m = 2.0 where k > 0.0;
        param level: N = 3.0 where level > 0.0;
        param reach: m = 5.0;
        param omega: rad/s = 1.0 where omega > 0.0;
        drive phi at omega;
        let speed = reach * omega * cos(phi);
        friction F: N = Jenkins { stiffness: k, level } opposing speed with z;
        der(loss) = -F * speed;
    }
}

/// 4 F (U − F/k) = 42 with k = 2, F = 3, U = 5: the area of its loop.
#[test]
fn one_jenkins_element_dissipates_42_a_cycle() {
    let system = System::of::<Moved, _>();
    let case = Case {
        accuracy: 1e-11,
        ..Case::of(&Moved::default())
    };
    let loss = |turns: f64| {
        let motion = system.motion(&case, turns * TAU).expect("a motion");
        motion.states.last().expect("an end")[0]
    };
    let cycle = loss(2.0) - loss(1.0);
    assert!((cycle - 42.0).abs() < 1e-9, "{cycle}");
}
