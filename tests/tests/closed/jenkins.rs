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

model! {
    /// A mass on two springs, the second of which slips, under a harmonic load.
    struct Jointed {
        state x: m = 0.0;
        state v: m/s = 0.0;
        state z: N = 0.0;
        param mass: kg = 1.0 where mass > 0.0;
        param k: N/m = 0.9;
        param joint: N/m = 0.1 where joint > 0.0;
        param damping: N*s/m = 0.01;
        param level: N = 0.05 where level > 0.0;
        param load: N = 0.1;
        param omega: rad/s = 0.8 where omega > 0.0;
        drive phi at omega;
        friction F: N = Jenkins { stiffness: joint, level } opposing v with z;
        der(x) = v;
        der(v) = (load * cos(phi) - k * x - damping * v + F) / mass;
    }
}

/// Its response does not depend on the level down to the force in the joint, and beyond falls with it at once: the branch
/// turns a corner, and is that of orbits which are found afresh.
#[test]
fn a_branch_turns_where_a_joint_begins_to_slip() {
    let model = Jointed::default();
    let stiff = model.k + model.joint - model.mass * model.omega.powi(2);
    let swing = model.load / stiff.hypot(model.damping * model.omega);
    let system = System::of::<Jointed, _>();
    let branch = system
        .branch(&Case::of(&model).following(Jointed::level, 0.05..0.01))
        .unwrap();
    assert_eq!(branch.ended.word(), "reached-end", "{:?}", branch.ended);
    assert!(branch.special.is_empty(), "{:?}", branch.special);
    let sticks = branch
        .points
        .iter()
        .filter(|point| point.r > Some(model.joint * swing));
    for point in sticks {
        assert!(
            (point.max[0] / swing - 1.0).abs() < 1e-8,
            "{}",
            point.max[0]
        );
    }
    let last = branch.points.last().unwrap();
    let afresh = system
        .orbit(&Case::of(&Jointed {
            level: 0.01,
            ..model
        }))
        .unwrap();
    assert!((last.max[0] / afresh.max[0] - 1.0).abs() < 1e-8);
    assert!((last.max[0] / swing - 1.0).abs() > 1e-2);
}
