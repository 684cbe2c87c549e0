//! Impacts against closed forms.

use std::f64::consts::{PI, TAU};

use stickslip::continuation::Kind;
use stickslip::field::Design;
use stickslip::flow::exact::ExactFlow;
use stickslip::flow::{EventKind, Flow, FlowError, Want};
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip::study::{Along, BranchRecord, Case, Dynamics, OrbitRecord, System};

use crate::models::{Bouncing, Hammer, Rattle, Valve, flow};

/// A model from this start, sharply.
pub(crate) fn case<M: Model<N>, const N: usize>(model: &M, start: &[f64]) -> Case {
    let mut case = Case::declared(M::INFO, Dynamics::Exact);
    case.parameters = model.values().as_ref().to_vec();
    case.start = Some(start.to_vec());
    case.accuracy = 1e-11;
    case
}

/// Its branch along a parameter.
pub(crate) fn branch<M: Model<N>, const N: usize>(
    case: &Case,
    parameter: usize,
    (from, to): (f64, f64),
) -> BranchRecord {
    let mut along = case.clone();
    along.parameters[parameter] = from;
    along.along = Some(Along {
        design: Design::Parameter(parameter),
        from,
        to,
    });
    let branch = System::of::<M, N>().branch(&along);
    branch.unwrap()
}

/// The approach, the departure and the phase of each impact of an orbit.
fn impacts<M: Model<N>, const N: usize>(model: &M, orbit: &OrbitRecord) -> Vec<[f64; 3]> {
    let flow = flow(model, None);
    let start = std::array::from_fn(|i| orbit.state[i]);
    let place = flow.place(start).unwrap();
    let passage = flow.advance(&place, orbit.period, Want::default()).unwrap();
    let impact = |event: &stickslip::flow::Event<N>| match event.kind {
        EventKind::Impact {
            approach,
            departure,
        } => Some([approach, departure, event.time]),
        _ => None,
    };
    passage.events.iter().filter_map(impact).collect()
}

fn determinant(orbit: &OrbitRecord) -> f64 {
    let multipliers = orbit.floquet.multipliers.iter();
    multipliers.product::<nalgebra::Complex<f64>>().re
}

#[test]
fn the_impact_oscillator_has_its_closed_form() {
    let table = [
        (
            1.0,
            1.3565863500759048,
            0.0759521649383116,
            [-0.5842953143415295, 0.0056003514924761],
        ),
        (
            0.5,
            0.6696128185597274,
            0.1771123596906624,
            [-0.5811658910453443, 0.0606513428027527],
        ),
    ];
    for (load, departure, phase, multiplier) in table {
        let hammer = Hammer {
            load,
            ..Default::default()
        };
        let case = case(&hammer, &[1.0 - 0.07 * departure, -departure, 0.0]);
        let orbit = System::of::<Hammer, 3>().orbit(&case).unwrap();
        assert_eq!(orbit.word.as_deref(), Some("impact(R)"));
        assert!((orbit.period - TAU).abs() < 1e-12);
        let found = impacts(&hammer, &orbit);
        let [[v_in, v_out, time]] = found.as_slice() else {
            panic!("{found:?}");
        };
        assert!((v_out - departure).abs() < 1e-10, "{v_out}");
        assert!((v_in - departure / 0.8).abs() < 1e-10, "{v_in}");
        assert!((time - phase).abs() < 1e-10, "{time}");
        let found = orbit.floquet.multipliers[0];
        assert!((found.re - multiplier[0]).abs() < 1e-8, "{found}");
        assert!((found.im.abs() - multiplier[1]).abs() < 1e-8, "{found}");
        assert!((determinant(&orbit) - 0.34143237829830614).abs() < 1e-9);
        assert!(orbit.max[0] <= 1.0 + 1e-12, "never through the wall");
        assert!(orbit.max[1] > *v_in && orbit.min[1] <= 1e-9 - v_out);
    }
}

/// Born in a fold at Γ = π (1 − e)/(1 + e), doubled at Γ² = that² + (2 (1 + e²)/(1 + e)²)².
#[test]
fn a_ball_keeps_time_with_its_table_in_a_window() {
    for e in [0.8, 0.5, 0.3] {
        let born = PI * (1.0 - e) / (1.0 + e);
        let flips = born.hypot(2.0 * (1.0 + e * e) / ((1.0 + e) * (1.0 + e)));
        let gamma = 0.5 * (born + flips);
        let model = Bouncing {
            e,
            amplitude: gamma,
            ..Default::default()
        };
        let phase = (born / gamma).acos();
        // It leaves at speed π relative to the still table: v⁺ of the flight, seen from the phase 0 before the impact.
        let start = [
            gamma * phase.sin() + PI * phase - 0.5 * phase * phase,
            -PI + phase,
            0.0,
        ];
        let start = [start[0], start[1], 0.0];
        let case = case(&model, &start);
        let orbit = System::of::<Bouncing, 3>().orbit(&case).unwrap();
        let trace: f64 = orbit.floquet.multipliers.iter().map(|m| m.re).sum();
        assert!((trace - (1.0 + e * e - (1.0 + e).powi(2) * gamma * phase.sin())).abs() < 1e-8);
        assert!((determinant(&orbit) - e * e).abs() < 1e-9);
        let up = branch::<Bouncing, 3>(&case, Bouncing::amplitude.index, (gamma, 1.1 * flips));
        let flip = up
            .special
            .iter()
            .find(|special| special.kind == Kind::Flip)
            .expect("a flip");
        assert!((flip.r - flips).abs() < 1e-9, "{} {flips}", flip.r);
        let down = branch::<Bouncing, 3>(&case, Bouncing::amplitude.index, (gamma, 0.9 * born));
        let fold = down
            .special
            .iter()
            .find(|special| special.kind == Kind::Fold)
            .expect("a fold");
        assert!((fold.r - born).abs() < 1e-9, "{} {born}", fold.r);
    }
}

/// A disc comes down on its seat and turns within 1e-6 of it, above it or below: it is hit or not, and goes on.
#[test]
fn what_is_all_but_a_touch_is_passed() {
    let valve = Valve {
        q: 7.557_210_971_884_613,
        ..Default::default()
    };
    let tolerance = Tolerance::for_accuracy(1e-9);
    let flow = ExactFlow::new(&valve, None, tolerance).unwrap();
    let mut hit = 0;
    for k in -100..=100 {
        let lift = 8.409_427_242_194_937 + 1e-8 * f64::from(k);
        let start = [lift, -3.645_335_486_111_887, 0.800_558_098_799_663_7];
        let passage = flow.advance(&flow.place(start).unwrap(), 2.0, Want::EXTREMA);
        let passage = passage.unwrap_or_else(|error| panic!("{k}: {error}"));
        let impacts = passage.events.iter();
        hit += impacts
            .filter(|event| matches!(event.kind, EventKind::Impact { .. }))
            .count();
        assert!(passage.end.state[0] > 1.0, "{k}");
    }
    assert!((1..201).contains(&hit), "{hit}");
}

/// What an impact cannot answer is said, and named.
#[test]
fn walls_are_neither_passed_nor_rested_on_in_silence() {
    let hammer = flow(&Hammer::default(), None);
    let inside = hammer.place([1.2, 0.0, 0.0]).unwrap_err();
    assert!(
        matches!(inside, FlowError::Inside { contact, gap } if contact == 0 && (gap + 0.2).abs() < 1e-15)
    );
    let still = Bouncing {
        amplitude: 0.0,
        ..Default::default()
    };
    let ball = flow(&still, None);
    let place = ball.place([1.0, 0.0, 0.0]).unwrap();
    // It falls for the time √2, and its bounces add up to 2 √2 e/(1 − e).
    let stops = 2.0_f64.sqrt() * (1.0 + 2.0 * 0.8 / 0.2);
    let rests = ball.advance(&place, 1.01 * stops, Want::default());
    let rests = rests.unwrap();
    let settled = rests.events.last().unwrap();
    let EventKind::Settled { lasts, .. } = settled.kind else {
        panic!("{settled:?}");
    };
    let time = settled.time + lasts;
    assert!((time - stops).abs() < 1e-12 * stops, "{time} {stops}");
    assert_eq!(rests.end.state[..2], [0.0, 0.0]);
    let free = Rattle {
        shake: 0.0,
        rough: 0.0,
        spring: 0.0,
        ..Default::default()
    };
    let rattle = flow(&free, None);
    let place = rattle.place([0.3, -1.0, 0.7, -2.0, 0.0]).unwrap();
    let both = rattle.advance(&place, 1.0, Want::default()).unwrap_err();
    assert!(
        matches!(&both, FlowError::HitTogether { contacts, .. } if *contacts == [1, 2]),
        "{both}"
    );
}
