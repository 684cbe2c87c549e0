//! Contact that lasts: chatter comes to its end, reactions hold, and contacts let go where they vanish.

use std::f64::consts::{PI, TAU};

use stickslip::model::Model;
use stickslip::study::{Case, Dynamics, OrbitRecord, System};

use crate::models::Bouncing;

fn orbit<M: Model<N>, const N: usize>(model: &M, start: &[f64]) -> OrbitRecord {
    let mut case = Case::declared(M::INFO, Dynamics::Exact);
    case.parameters = model.values().as_ref().to_vec();
    case.start = Some(start.to_vec());
    case.accuracy = 1e-11;
    System::of::<M, N>().orbit(&case).unwrap()
}

/// Below the window in which it keeps time with the table, the ball ends at rest on it, and is thrown off where that falls
/// faster than gravity pulls: sin φ = 1/Γ.
#[test]
fn a_ball_rests_on_a_table_that_is_too_slow_to_keep_it_in_flight() {
    for (e, gamma) in [(0.8, 0.34), (0.5, 0.9), (0.3, 0.95), (0.5, 1.03), (0.3, 1.2), (0.3, 1.6)] {
        let born = PI * (1.0 - e) / (1.0 + e);
        assert!(gamma < born);
        let ball = Bouncing {
            e,
            amplitude: gamma,
            ..Default::default()
        };
        let orbit = orbit(&ball, &[1.0, 0.0, 0.0]);
        println!("{e} {gamma} {:?} {} {:?}", orbit.word, orbit.period / TAU, orbit.floquet.multipliers);
    }
}
