//! What must hold for any exact motion, whatever its numbers: symmetries, volumes, extremes.

use stickslip::flow::exact::ExactFlow;
use stickslip::flow::{Flow, FlowError, Want};
use stickslip::integrate::Tolerance;
use stickslip_models::{BeltOscillator, BeltPair, DrillString, VanDerPol};

const TIGHT: Tolerance = Tolerance {
    relative: 1e-12,
    absolute: 1e-12,
};
const ALL: Want = Want {
    path: true,
    factors: true,
    ..Want::SHOT
};

#[test]
fn a_mirrored_motion_is_the_mirror_image() {
    let model = BeltPair::default();
    let mirrored = BeltPair {
        v_dr: -model.v_dr,
        ..model
    };
    let (one, other) = (
        ExactFlow::new(&model, None, TIGHT).unwrap(),
        ExactFlow::new(&mirrored, None, TIGHT).unwrap(),
    );
    let start = [-0.5976, 0.0, -0.4604, -0.1607];
    let a = one.advance(&one.place(start).unwrap(), 40.0, ALL).unwrap();
    let b = other
        .advance(&other.place(start.map(|y| -y)).unwrap(), 40.0, ALL)
        .unwrap();
    assert_eq!(a.end.state, b.end.state.map(|y| -y));
    assert_eq!(a.derivatives.unwrap().state, b.derivatives.unwrap().state);
    assert_eq!(a.work, b.work);
}

#[test]
fn uncoupled_masses_move_as_if_alone() {
    let pair = BeltPair {
        alpha: 0.0,
        beta: 1.0,
        ..Default::default()
    };
    let single = BeltOscillator {
        v_dr: pair.v_dr,
        ..Default::default()
    };
    let (pair, single) = (
        ExactFlow::new(&pair, None, TIGHT).unwrap(),
        ExactFlow::new(&single, None, TIGHT).unwrap(),
    );
    let (first, second) = ([0.3, 0.14], [-0.2, -0.5]);
    let both = pair
        .place([first[0], first[1], second[0], second[1]])
        .unwrap();
    let both = pair
        .advance(&both, 50.0, Want::default())
        .unwrap()
        .end
        .state;
    for (start, end) in [(first, [both[0], both[1]]), (second, [both[2], both[3]])] {
        let alone = single
            .advance(&single.place(start).unwrap(), 50.0, Want::default())
            .unwrap();
        for (a, b) in alone.end.state.iter().zip(&end) {
            assert!((a - b).abs() < 1e-9, "{a} {b}");
        }
    }
}

#[test]
fn volumes_change_as_liouville_says_while_no_event_comes() {
    let model = BeltOscillator::default();
    let flow = ExactFlow::new(&model, None, TIGHT).unwrap();
    let passage = flow
        .advance(&flow.place([1.1, -0.2]).unwrap(), 2.0, ALL)
        .unwrap();
    assert_eq!(passage.segments.len(), 1);
    let derivatives = passage.derivatives.unwrap();
    let [[a, b], [c, d]] = derivatives.state;
    assert!(((a * d - b * c).ln() - derivatives.determinant.log).abs() < 1e-11);
    assert!(
        derivatives.determinant.log > 0.0,
        "weakening friction feeds the motion"
    );
}

#[test]
fn a_model_without_friction_flows_too() {
    let flow = ExactFlow::new(&VanDerPol::default(), None, TIGHT).unwrap();
    let period = 6.663_286_859_323_13;
    let place = flow.place([2.008_619_860_874_843, 0.0]).unwrap();
    let passage = flow.advance(&place, period, ALL).unwrap();
    assert!(
        (passage.end.state[0] - place.state[0]).abs() < 1e-9,
        "{:?}",
        passage.end
    );
    assert!(passage.events.is_empty() && passage.segments.len() == 1);
}

/// More steps than these within a few periods, and a user would call it a hang.
const STEPS: u64 = 1_000_000;

/// Answers, and soon.
fn answers(model: &BeltOscillator, start: [f64; 2]) -> bool {
    let flow = ExactFlow::new(model, Some(BeltOscillator::v_dr), TIGHT).unwrap();
    let outcome = flow
        .place(start)
        .and_then(|place| flow.advance(&place, 40.0 / model.k.sqrt(), ALL));
    match outcome {
        Ok(passage) => {
            let steps = passage.work.steps + passage.work.rejected;
            assert!(steps < STEPS, "{model:?} {start:?}: {steps} steps");
            let finite = passage.end.state.iter().all(|y| y.is_finite());
            assert!(finite, "{model:?} {start:?}: {:?}", passage.end.state);
            true
        }
        Err(FlowError::SensitivityUndefined(_)) => true,
        // Where doubles cannot resolve the speed or the time in which friction changes, an error may say so.
        Err(FlowError::Integration(_) | FlowError::Chattering { .. }) => {
            model.delta * model.v_dr.abs().max(model.F_s) > 1e10
        }
        Err(error) => panic!("{model:?} {start:?}: {error}"),
    }
}

fn extremes_have_answers(limits: &[f64], scales: &[f64]) {
    for &limit in limits {
        for delta in [0.0, 3.0, 1e8] {
            for v_dr in [0.0, 1e-8, -0.2, 1e3] {
                for &k in scales {
                    let model = BeltOscillator {
                        F_s: limit,
                        delta,
                        v_dr,
                        k,
                        ..Default::default()
                    };
                    for start in [[0.0, v_dr], [1.0, 0.0], [-3.0, v_dr]] {
                        assert!(answers(&model, start));
                    }
                }
            }
        }
    }
}

#[test]
fn extreme_friction_has_answers() {
    extremes_have_answers(&[0.0, 1e-12, 1.0, 1e6], &[1.0]);
}

#[test]
#[ignore = "long"]
fn extreme_parameters_have_answers_where_friction_is_weak() {
    extremes_have_answers(&[0.0, 1e-12], &[1e-6, 1e6]);
}

#[test]
#[ignore = "long"]
fn extreme_parameters_have_answers_where_friction_is_strong() {
    extremes_have_answers(&[1.0, 1e6], &[1e-6, 1e6]);
}

#[test]
fn the_slowest_table_still_turns() {
    let model = DrillString {
        eta: 1e-6,
        ..Default::default()
    };
    let flow = ExactFlow::new(&model, None, TIGHT).unwrap();
    let passage = flow
        .advance(&flow.place([0.0, 1e-6]).unwrap(), 2e7, ALL)
        .unwrap();
    let highest = passage
        .extrema
        .iter()
        .map(|e| e.state[0])
        .fold(f64::MIN, f64::max);
    assert!((highest - 4.2).abs() < 1e-6, "{highest}");
    assert!(passage.events.len() >= 4);
}
