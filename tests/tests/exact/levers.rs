//! Friction on a lever arm that vanishes somewhere: at its dead centres it has no effect, and is let pass.

use std::f64::consts::PI;

use stickslip::flow::{EventKind, Want};
use stickslip::model;
use stickslip::motion::Family;
use stickslip_models::friction::Coulomb;
use stickslip_tests::exact;

const ACCURACY: f64 = 1e-11;

model! {
    /// A crank that drives a slider, which rubs: its speed is reach sin φ · w.
    struct Crank {
        state phi = 0.0;
        state w = 0.0;
        param inertia = 1.0 where inertia > 0.0;
        param reach = 0.5;
        param level = 1.0 where level >= 0.0;
        param torque = 1.0;
        friction F = Coulomb { level: level } opposing reach * sin(phi) * w;
        der(phi) = w;
        der(w) = (torque + F * reach * sin(phi)) / inertia;
    }
}

/// While it turns forward, w² = w₀² + 2 (torque φ − level reach ∫|sin φ| dφ)/inertia: begun at a dead centre, at rest or
/// not, and at each that it passes.
#[test]
fn a_crank_passes_its_dead_centres() {
    for (reach, torque, w) in [
        (0.5, 1.0, 0.0),
        (0.5, 1.0, 1.0),
        (-0.5, 1.0, 2.0),
        (1.2, 1.2, 0.0),
        (0.5, -1.0, -1.0),
    ] {
        let crank = Crank {
            reach,
            torque,
            ..Crank::default()
        };
        let family: Family = exact::family(crank, ACCURACY).into();
        let flow = family.at(0.0).unwrap();
        let place = flow.place(&[0.0, w]).unwrap();
        let want = Want {
            derivatives: w != 0.0,
            ..Want::default()
        };
        let passage = flow.advance(&place, 12.0, want).unwrap();
        let crossings = passage.events.iter();
        let crossings = crossings.filter(|event| matches!(event.kind, EventKind::Crossing { .. }));
        let mut passed = 0;
        for event in crossings {
            let (phi, half_turns) = (event.state[0], (event.state[0] / PI).round());
            assert!((phi - PI * half_turns).abs() < 1e-9, "{phi}");
            let lost = crank.level * reach.abs() * 2.0 * half_turns.abs();
            let square = w * w + 2.0 * (torque * phi - lost) / crank.inertia;
            assert!(
                ((event.state[1] / square.sqrt()).abs() - 1.0).abs() < 1e-9,
                "{phi}: {}",
                event.state[1]
            );
            passed += 1;
        }
        assert!(passed > 5, "{passed}");
    }
}
