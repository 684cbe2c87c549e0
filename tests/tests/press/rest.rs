//! Contact that lasts: chatter comes to its end, reactions hold, and contacts let go where they vanish.

use std::f64::consts::{PI, TAU};

use stickslip::field::exact::{ContactError, Mode};
use stickslip::flow::{EventKind, Flow, FlowError, Want};
use stickslip::model::Model;
use stickslip::motion;
use stickslip::study::{Case, Dynamics, OrbitRecord, System};

use crate::models::{Bouncing, Ramp, Shelf, Tower, flow};

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
    for (e, gamma) in [
        (0.8, 0.34),
        (0.5, 0.9),
        (0.3, 0.95),
        (0.5, 1.03),
        (0.3, 1.2),
        (0.3, 1.6),
    ] {
        let born = PI * (1.0 - e) / (1.0 + e);
        assert!(gamma < born);
        let ball = Bouncing {
            e,
            amplitude: gamma,
            ..Default::default()
        };
        let orbit = orbit(&ball, &[1.0, 0.0, 0.0]);
        assert!(
            (orbit.period - TAU).abs() < 1e-9,
            "{e} {gamma}: {}",
            orbit.period
        );
        let multipliers = &orbit.floquet.multipliers;
        assert!(
            multipliers.iter().all(|m| m.norm() == 0.0),
            "{multipliers:?}"
        );
        let thrown = gamma > 1.0;
        let word = if thrown {
            "impact(R) rest(R) open(R)"
        } else {
            "rest(R)"
        };
        assert_eq!(orbit.word.as_deref(), Some(word), "{e} {gamma}");
        if thrown {
            let flow = flow(&ball, None);
            let start = std::array::from_fn(|i| orbit.state[i]);
            let place = flow.place(start).unwrap();
            let passage = flow.advance(&place, TAU, Want::default()).unwrap();
            let mut events = passage.events.iter();
            let release = events
                .find(|event| event.kind == EventKind::Opening)
                .unwrap();
            let fall = gamma * release.state[2].sin();
            assert!((fall - 1.0).abs() < 1e-10, "{fall}");
        }
    }
}

#[test]
fn masses_stand_on_each_other_with_their_weight() {
    let tower = Tower::default();
    let flow = flow(&tower, None);
    let place = flow.place([0.0, 0.0, 1.0, 0.0]).unwrap();
    assert_eq!(place.mode.as_slice(), [Mode::Rest, Mode::Rest]);
    let end = flow.advance(&place, 3.0, Want::default()).unwrap().end;
    assert_eq!(end.state, [0.0, 0.0, 1.0, 0.0]);
    let loads = motion::Flow::read(
        &flow,
        &motion::Place {
            state: place.state.to_vec(),
            modes: place.mode.as_slice().to_vec(),
        },
    );
    let (forces, _) = loads.unwrap();
    assert!(
        (forces[0] - 3.0).abs() < 1e-14 && (forces[1] - 2.0).abs() < 1e-14,
        "{forces:?}"
    );
    // What falls on something that stands hits it together with the ground.
    let falls = flow.place([0.0, 0.0, 1.5, 0.0]).unwrap();
    let error = flow.advance(&falls, 3.0, Want::default()).unwrap_err();
    assert!(
        matches!(&error, FlowError::HitTogether { contacts, time } if *contacts == [0, 1] && (time - 1.0).abs() < 1e-12),
        "{error}"
    );
}

#[test]
fn what_rests_on_the_ground_is_an_equilibrium() {
    let case = Case::declared(Tower::INFO, Dynamics::Exact);
    let found = System::of::<Tower, 4>().equilibria(&case).unwrap();
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0].mode.as_deref(), Some("rest(A) rest(B)"));
    let state = &found[0].state;
    let exact = [0.0, 0.0, 1.0, 0.0];
    assert!(
        state
            .iter()
            .zip(exact)
            .all(|(y, exact)| (y - exact).abs() < 1e-12),
        "{state:?}"
    );
    assert!(found[0].set.is_none() && found[0].eigenvalues.is_empty());
}

#[test]
fn impacts_at_one_time_that_do_not_act_on_each_other_pass_in_any_order() {
    let shelf = Shelf {
        shake: 0.0,
        tie: 0.0,
        drag: 0.0,
        ..Default::default()
    };
    let flow = flow(&shelf, None);
    let place = flow.place([0.5, 0.0, 0.5, 0.0, 0.0]).unwrap();
    let passage = flow.advance(&place, 1.2, Want::default()).unwrap();
    let times: Vec<f64> = passage.events.iter().map(|event| event.time).collect();
    assert!(
        (times[0] - 1.0).abs() < 1e-12 && (times[1] - 1.0).abs() < 1e-12,
        "{times:?}"
    );
    assert!((passage.end.state[1] - (shelf.e1 - 0.2)).abs() < 1e-12);
    assert!((passage.end.state[3] - (shelf.e2 - 0.2)).abs() < 1e-12);
}

/// Of a reaction R and its friction −μR, the rate of the gap keeps 1 + s²/m − μ s (1/m − 1) for a slope −s.
#[test]
fn where_friction_turns_a_reaction_around_nothing_is_said() {
    let ramp = |mu: f64| Ramp {
        shake: 0.0,
        mu,
        slope: -0.4,
        wide: 0.1,
        ..Default::default()
    };
    let slides = |mu: f64| flow(&ramp(mu), None).place([0.0, 1.0, 0.0, -0.4, 0.0]);
    let compliance = |mu: f64| 1.0 + 0.16 / 0.1 - mu * 0.4 * 9.0;
    assert!(compliance(0.7) > 0.0 && compliance(0.75) < 0.0);
    assert_eq!(slides(0.7).unwrap().mode.as_slice()[1], Mode::Rest);
    let error = slides(0.75).unwrap_err();
    let FlowError::Contact(ContactError::Painleve {
        contact,
        compliance: found,
    }) = error
    else {
        panic!("{error}");
    };
    assert_eq!(contact, 1);
    assert!((found - compliance(0.75)).abs() < 1e-12, "{found}");
}
