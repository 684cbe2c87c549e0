//! Φ and ∂φ/∂r of the exact flow against central differences, through every kind of event.
//!
//! A wrong saltation leaves values exact and only gradients wrong: nothing else would notice.

use std::ops::ControlFlow;

use stickslip::field::exact::{ExactField, ExactSystem, Mode, Modes};
use stickslip::field::{Field, Linear, Work};
use stickslip::flow::exact::ExactFlow;
use stickslip::flow::{EventKind, Flow, FlowError, Passage, Place, SensitivityUndefined, Want};
use stickslip::integrate::Tolerance;
use stickslip::integrate::explicit::{Settings, Stepper, integrate};
use stickslip::model::{Model, ParamId};
use stickslip_models::closed_form::Ringdown;
use stickslip_models::friction::{CoulombStatic, Weakening};
use stickslip_models::{BeltOscillator, BeltPair, DrillString};

const TIGHT: Tolerance = Tolerance {
    relative: 1e-13,
    absolute: 1e-13,
};
const DERIVATIVES: Want = Want::DERIVATIVES;

stickslip::model! {
    /// A sledge on a belt that carries another, its mass growing with its place: G is full and not constant.
    pub struct Sledges {
        state x1 = 0.0;
        state v1 = 0.0;
        state x2 = 0.0;
        state v2 = 0.0;
        param v_dr = 0.3;
        param upper = 0.7 where upper > 0.0;
        param peak = 1.2 where peak >= 1.0;
        param growth = 0.2 where growth >= 0.0;
        friction ground = CoulombStatic { static_level: peak, kinetic_level: 1.0 } opposing v1 - v_dr;
        friction between = Weakening { limit: 0.5, decay: 2.0 } opposing v2 - v1;
        der(x1) = v1;
        der(v1) = (ground - between - x1) / (1.0 + growth * x1 * x1);
        der(x2) = v2;
        der(v2) = (between - x2 - 0.3 * x2 * x2 * x2) / upper;
    }
}

stickslip::model! {
    /// A bead on a belt whose speed depends on the place: w is not affine.
    pub struct Groove {
        state x = 1.0;
        state v = 0.0;
        param v_dr = 0.3;
        param peak = 1.1 where peak >= 1.0;
        param curvature = 0.2;
        friction F = CoulombStatic { static_level: peak, kinetic_level: 0.8 }
            opposing v - v_dr * (1.0 + curvature * x * x);
        der(x) = v;
        der(v) = F - x;
    }
}

type Motion<M, const N: usize> = Passage<N, Modes<M, N>>;

/// The passage with its derivatives, after comparing them with differences for every state and parameter.
fn checked<M: Model<N>, const N: usize>(model: &M, start: [f64; N], time: f64) -> Motion<M, N> {
    let flow = ExactFlow::new(model, None, TIGHT).unwrap();
    let place = flow.place(start).unwrap();
    let passage = flow.advance(&place, time, DERIVATIVES).unwrap();
    let derivatives = passage.derivatives.as_ref().unwrap();
    let end = |model: &M, state: [f64; N]| {
        let flow = ExactFlow::new(model, None, TIGHT).unwrap();
        let place = Place {
            state,
            mode: place.mode,
        };
        let other = flow.advance(&place, time, Want::default()).unwrap();
        assert_eq!(
            other.end.mode, passage.end.mode,
            "the step of the difference is too long"
        );
        other.end.state
    };
    for column in 0..N {
        let exact = std::array::from_fn(|row| derivatives.state[row][column]);
        let slope = difference(|shift| {
            let mut state = start;
            state[column] += shift;
            end(model, state)
        });
        assert_close(exact, slope, &format!("state {column}"));
    }
    for parameter in 0..model.values().as_ref().len() {
        let design = Some(ParamId::new(parameter));
        let flow = ExactFlow::new(model, design, TIGHT).unwrap();
        let with = flow.advance(&place, time, DERIVATIVES).unwrap();
        let slope = difference(|shift| {
            let mut values = model.values();
            values.as_mut()[parameter] += shift;
            end(&M::from_values(values), start)
        });
        assert_close(
            with.derivatives.unwrap().design,
            slope,
            M::INFO.parameters[parameter].name,
        );
    }
    let product = derivatives
        .factors
        .iter()
        .fold(identity(), |all, factor| multiply(&factor.state, &all));
    assert_eq!(
        product, derivatives.state,
        "Φ is the product of its factors"
    );
    assert_eq!(derivatives.factors.len(), passage.segments.len());
    passage
}

/// Central difference of order 4.
fn difference<const N: usize>(end: impl Fn(f64) -> [f64; N]) -> [f64; N] {
    let h = 5e-5;
    let [a, b, c, d] = [2.0 * h, h, -h, -2.0 * h].map(end);
    std::array::from_fn(|i| (8.0 * (b[i] - c[i]) - (a[i] - d[i])) / (12.0 * h))
}

fn assert_close<const N: usize>(exact: [f64; N], slope: [f64; N], what: &str) {
    for i in 0..N {
        let error = (exact[i] - slope[i]).abs();
        assert!(
            error < 3e-8 * (1.0 + exact[i].abs()),
            "d y{i} / d {what}: {} by saltation, {} by differences",
            exact[i],
            slope[i]
        );
    }
}

fn identity<const N: usize>() -> [[f64; N]; N] {
    std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)))
}

fn multiply<const N: usize>(a: &[[f64; N]; N], b: &[[f64; N]; N]) -> [[f64; N]; N] {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..N).map(|k| a[i][k] * b[k][j]).sum()))
}

fn count<M: Model<N>, const N: usize>(passage: &Motion<M, N>, of: fn(&EventKind) -> bool) -> usize {
    passage
        .events
        .iter()
        .filter(|event| of(&event.kind))
        .count()
}

fn landings<M: Model<N>, const N: usize>(passage: &Motion<M, N>) -> usize {
    count(passage, |kind| matches!(kind, EventKind::Landing { .. }))
}

fn releases<M: Model<N>, const N: usize>(passage: &Motion<M, N>) -> usize {
    count(passage, |kind| matches!(kind, EventKind::Release { .. }))
}

fn crossings<M: Model<N>, const N: usize>(passage: &Motion<M, N>) -> usize {
    count(passage, |kind| matches!(kind, EventKind::Crossing { .. }))
}

#[test]
fn through_a_landing() {
    let passage = checked(&BeltOscillator::default(), [1.1, -0.1], 4.0);
    assert_eq!((landings(&passage), releases(&passage)), (1, 0));
    let derivatives = passage.derivatives.unwrap();
    // What sticks inherits the belt: w_y Φ = 0 exactly.
    assert_eq!(derivatives.state[1], [0.0, 0.0]);
}

#[test]
fn the_mass_inherits_the_speed_of_the_belt() {
    let flow = ExactFlow::new(
        &BeltOscillator::default(),
        Some(BeltOscillator::v_dr),
        TIGHT,
    )
    .unwrap();
    let place = flow.place([1.1, -0.1]).unwrap();
    let passage = flow.advance(&place, 4.0, DERIVATIVES).unwrap();
    assert_eq!(passage.derivatives.unwrap().design[1], 1.0);
}

#[test]
fn through_a_tangential_release() {
    let passage = checked(&BeltOscillator::default(), [1.1, -0.1], 14.0);
    assert_eq!((landings(&passage), releases(&passage)), (1, 1));
    let passage = checked(&BeltOscillator::default(), [1.1, -0.1], 40.0);
    assert_eq!((landings(&passage), releases(&passage)), (4, 3));
}

#[test]
fn through_a_transversal_release() {
    let passage = checked(&DrillString::default(), [0.4, 4.0], 8.0);
    assert!(
        landings(&passage) >= 1 && releases(&passage) >= 1,
        "{:?}",
        passage.events
    );
}

#[test]
fn from_a_start_that_sticks() {
    let passage = checked(&BeltOscillator::default(), [0.4, 0.2], 5.0);
    assert_eq!((landings(&passage), releases(&passage)), (0, 1));
    let derivatives = passage.derivatives.unwrap();
    let column = [derivatives.state[0][1], derivatives.state[1][1]];
    assert_eq!(column, [0.0, 0.0], "a speed off the belt's is put on it");
}

#[test]
fn through_crossings() {
    let model = BeltOscillator {
        v_dr: 1.0,
        ..Default::default()
    };
    let passage = checked(&model, [1.2, 0.5], 14.0);
    assert!(crossings(&passage) >= 1, "{:?}", passage.events);
}

#[test]
fn of_two_contacts() {
    let passage = checked(&BeltPair::default(), [-0.5976, 0.0, -0.4604, -0.1607], 16.1);
    assert!(landings(&passage) >= 2 && releases(&passage) >= 2);
    let model = BeltPair {
        v_dr: 0.35,
        ..Default::default()
    };
    checked(&model, [-0.02798, 0.0, 0.678, 0.3089], 6.0);
}

#[test]
fn of_coupled_contacts_whose_inputs_vary() {
    let passage = checked(&Sledges::default(), [2.8, -0.2, -1.4, 0.6], 9.0);
    assert!(passage.events.len() >= 4, "{:?}", passage.events);
    let passage = checked(&Sledges::default(), [0.2, 0.3, 0.1, 0.3], 7.0);
    assert_eq!(
        passage.segments[0].mode.as_slice(),
        [Mode::Stick, Mode::Stick]
    );
}

#[test]
fn of_a_contact_whose_speed_is_not_affine() {
    let passage = checked(&Groove::default(), [-0.5, 0.315], 14.0);
    assert!(
        landings(&passage) >= 1 && releases(&passage) >= 1,
        "{:?}",
        passage.events
    );
}

#[test]
fn of_decoupled_contacts_that_switch_together() {
    let model = BeltPair {
        alpha: 0.0,
        beta: 1.0,
        ..Default::default()
    };
    let passage = checked_only_states(&model, [0.3, 0.14, 0.3, 0.14], 9.0);
    let together = passage.events.windows(2).any(|e| e[0].time == e[1].time);
    assert!(together, "{:?}", passage.events);
}

/// Simultaneous events of decoupled contacts: each must have the derivative of the single mass.
fn checked_only_states(model: &BeltPair, start: [f64; 4], time: f64) -> Motion<BeltPair, 4> {
    let flow = ExactFlow::new(model, Some(BeltPair::v_dr), TIGHT).unwrap();
    let passage = flow
        .advance(&flow.place(start).unwrap(), time, DERIVATIVES)
        .unwrap();
    let single = BeltOscillator {
        v_dr: model.v_dr,
        delta: model.gamma,
        ..Default::default()
    };
    let flow = ExactFlow::new(&single, Some(BeltOscillator::v_dr), TIGHT).unwrap();
    let one = flow
        .advance(
            &flow.place([start[0], start[1]]).unwrap(),
            time,
            DERIVATIVES,
        )
        .unwrap();
    let (pair, one) = (
        passage.derivatives.clone().unwrap(),
        one.derivatives.unwrap(),
    );
    for i in 0..4 {
        assert!((pair.design[i] - one.design[i % 2]).abs() < 1e-9);
        for j in 0..4 {
            let expected = if i / 2 == j / 2 {
                one.state[i % 2][j % 2]
            } else {
                0.0
            };
            assert!((pair.state[i][j] - expected).abs() < 1e-9, "{i} {j}");
        }
    }
    passage
}

#[test]
fn grazing_is_an_error_only_where_derivatives_are_wanted() {
    // ω exceeds η by 1e-9 only: to a tolerance of 1e-7 that may be a miss as well.
    let model = DrillString::default();
    let start = grazing_start(&model, 1e-9);
    let run = |digits: i32, want: Want| {
        let tolerance = Tolerance {
            relative: 0.1_f64.powi(digits),
            absolute: 0.1_f64.powi(digits),
        };
        let flow = ExactFlow::new(&model, None, tolerance).unwrap();
        flow.advance(&flow.place(start).unwrap(), 2.0, want)
    };
    assert_eq!(landings(&run(12, Want::default()).unwrap()), 1);
    assert!(run(7, Want::default()).is_ok());
    assert!(run(12, DERIVATIVES).is_ok());
    let outcome = run(7, DERIVATIVES);
    let grazes = matches!(
        outcome,
        Err(FlowError::SensitivityUndefined(
            SensitivityUndefined::Grazing { contact, .. }
        )) if contact == 0
    );
    assert!(grazes || outcome.is_ok_and(|p| p.events.is_empty()));
}

/// Backwards along the closed-form slip flow from the point of largest speed, `excess` above the table's.
fn grazing_start(model: &DrillString, excess: f64) -> [f64; 2] {
    let rate = model.eta + excess;
    let slip = Ringdown {
        damping: model.zeta,
        position: -2.0 * model.zeta * rate,
        rate,
    };
    [slip.position(-1.5), slip.rate(-1.5)]
}

/// The same field with time turned back.
struct Backwards<'s>(ExactField<'s, Sledges, 4>);

impl Field<4> for Backwards<'_> {
    fn f(&self, y: &[f64; 4]) -> [f64; 4] {
        self.0.f(y).map(|f| -f)
    }

    fn linearise(&self, y: &[f64; 4]) -> Linear<4> {
        self.0.linearise(y)
    }
}

#[test]
fn coupled_landings_at_one_time_have_no_derivative() {
    let model = Sledges::default();
    let system = ExactSystem::new(&model, None);
    let modes = Modes::from_fn(|_| Mode::SlideBackward);
    let meeting = [0.2, 0.3, -0.5, 0.3];
    let field = Backwards(ExactField::new(&system, modes, &meeting).unwrap());
    let settings = Settings::new(TIGHT);
    let mut work = Work::default();
    let go_on = |_: &mut Stepper<'_, Backwards<'_>, [f64; 4], 4>| ControlFlow::Continue(());
    let start = integrate(&field, settings, meeting, 0.2, &mut work, go_on).unwrap();
    let loose = Tolerance {
        relative: 1e-10,
        absolute: 1e-10,
    };
    let flow = ExactFlow::new(&model, None, loose).unwrap();
    let place = flow.place(start).unwrap();
    assert_eq!(place.mode, modes);
    let passage = flow.advance(&place, 0.3, Want::default()).unwrap();
    assert_eq!(
        passage.events[0].time, passage.events[1].time,
        "{:?}",
        passage.events
    );
    let outcome = flow.advance(&place, 0.3, DERIVATIVES);
    assert!(
        matches!(
            &outcome,
            Err(FlowError::SensitivityUndefined(SensitivityUndefined::Simultaneous { contacts, .. }))
                if contacts == &[0, 1]
        ),
        "{outcome:?}"
    );
}
