//! Φ and ∂φ/∂r through presses against central differences, for random states of systems with two to four contacts.

use std::collections::BTreeMap;

use stickslip::field::exact::{Mode, Modes};
use stickslip::flow::exact::ExactFlow;
use stickslip::flow::{EventKind, Flow, Segment, Want};
use stickslip::model::Model;
use stickslip_tests::random::Random;

use crate::models::{Ball, Bilinear, Squeal, Stack, TIGHT, flow};

/// A difference that changes by more with its step is none.
const DOUBT: f64 = 1e-6;

#[derive(Debug, Default)]
pub(crate) struct Tally {
    pub(crate) compared: usize,
    doubtful: usize,
    undefined: usize,
    pub(crate) events: BTreeMap<String, usize>,
}

/// Compares derivatives by every state and parameter with central differences of order 4.
pub(crate) fn compare<M: Model<N>, const N: usize>(
    model: &M,
    start: [f64; N],
    time: f64,
    tally: &mut Tally,
) {
    let whole = flow(model, None);
    let place = whole.place(start).unwrap();
    let passage = match whole.advance(&place, time, Want::SHOT) {
        Ok(passage) => passage,
        Err(error) => {
            let said = error.to_string();
            assert!(said.contains("no derivative"), "{said}");
            tally.undefined += 1;
            return;
        }
    };
    for event in &passage.events {
        let kind = match event.kind {
            EventKind::Landing { .. } => "landing",
            EventKind::Crossing { .. } => "crossing",
            EventKind::Release { .. } => "release",
            EventKind::Settled { .. } => "settling",
            EventKind::Closing => "closing",
            EventKind::Opening if event.mode == Mode::Parted => "parting",
            EventKind::Opening => "opening",
            EventKind::Impact { .. } => "impact",
            EventKind::Nearest { .. } => continue,
        };
        let contact = M::INFO.contact(event.contact).unwrap();
        *tally.events.entry(format!("{kind} {contact}")).or_default() += 1;
        if event.kind == EventKind::Opening && sticks(&passage.segments, event.time) {
            *tally.events.entry(format!("loss {contact}")).or_default() += 1;
        }
    }
    let derivatives = passage.derivatives.as_ref().unwrap();
    let end = |model: &M, state: [f64; N]| {
        let flow = ExactFlow::new(model, None, TIGHT).ok()?;
        let place = flow.place(state).ok()?;
        Some(flow.advance(&place, time, Want::default()).ok()?.end.state)
    };
    let mut judge = |exact: [f64; N], of: &dyn Fn(f64) -> Option<[f64; N]>, what: &str| {
        let slopes = [4e-5, 2e-5].map(|h| difference(of, h));
        let [Some(wide), Some(narrow)] = slopes else {
            tally.doubtful += 1;
            return;
        };
        for i in 0..N {
            let size = 1.0 + exact[i].abs();
            if (wide[i] - narrow[i]).abs() > DOUBT * size {
                tally.doubtful += 1;
                continue;
            }
            tally.compared += 1;
            let error = (exact[i] - narrow[i]).abs();
            let doubt = (wide[i] - narrow[i]).abs();
            assert!(
                error < 1e-7 * size + 4.0 * doubt,
                "d y{i} / d {what}: {} by saltation, {} by differences {doubt:e} from {start:?} over {time}",
                exact[i],
                narrow[i]
            );
        }
    };
    for column in 0..N {
        let exact = std::array::from_fn(|row| derivatives.state[row][column]);
        let shifted = |shift: f64| {
            let mut state = start;
            state[column] += shift;
            end(model, state)
        };
        judge(exact, &shifted, M::INFO.states[column].name);
    }
    for parameter in 0..model.values().as_ref().len() {
        let along = flow(model, Some(parameter));
        let along = along.advance(&place, time, Want::DERIVATIVES).unwrap();
        let shifted = |shift: f64| {
            let mut values = model.values();
            values.as_mut()[parameter] += shift;
            end(&M::from_values(values), start)
        };
        let exact = along.derivatives.unwrap().design;
        judge(exact, &shifted, M::INFO.parameters[parameter].name);
    }
}

/// Whether something sticks in the segment that ends at this time.
fn sticks<M: Model<N>, const N: usize>(segments: &[Segment<Modes<M, N>>], time: f64) -> bool {
    let mut end = 0.0;
    segments.iter().any(|segment| {
        end += segment.duration;
        (end - time).abs() < 1e-12 * (1.0 + time)
            && segment.duration > 0.0
            && segment.mode.as_slice().contains(&Mode::Stick)
    })
}

fn difference<const N: usize>(end: &dyn Fn(f64) -> Option<[f64; N]>, h: f64) -> Option<[f64; N]> {
    let [a, b, c, d] = [2.0 * h, h, -h, -2.0 * h].map(end);
    let (a, b, c, d) = (a?, b?, c?, d?);
    Some(std::array::from_fn(|i| {
        (8.0 * (b[i] - c[i]) - (a[i] - d[i])) / (12.0 * h)
    }))
}

/// Compares for as many random models, starts and times.
pub(crate) fn tally<M: Model<N>, const N: usize>(
    runs: usize,
    mut draw: impl FnMut(&mut Random) -> (M, [f64; N], f64),
) -> Tally {
    let (mut tally, mut random) = (Tally::default(), Random::new(15));
    for _ in 0..runs {
        let (model, start, time) = draw(&mut random);
        compare(&model, start, time, &mut tally);
    }
    println!("{tally:?}");
    assert!(tally.doubtful * 10 < tally.compared, "{tally:?}");
    assert!(tally.undefined * 10 < runs, "{tally:?}");
    tally
}

/// Each of these events was passed.
pub(crate) fn happened(tally: &Tally, events: &[&str]) {
    for event in events {
        assert!(tally.events.get(*event) >= Some(&3), "{event}: {tally:?}");
    }
}

#[test]
fn through_a_damped_wall() {
    let tally = tally(20, |random| {
        let model = Bilinear {
            wall: random.between(3.0, 20.0),
            c: random.between(0.1, 2.0),
            gap: random.real(0.2),
            ..Default::default()
        };
        let start = [random.between(0.3, 1.0), random.real(1.0)];
        (model, start, random.between(2.0, 8.0))
    });
    happened(&tally, &["closing N", "parting N"]);
}

#[test]
fn through_squeal() {
    let tally = tally(20, |random| {
        let model = Squeal {
            load: random.between(0.05, 0.6),
            mu: random.between(0.8, 1.4),
            belt: random.between(0.1, 0.8),
            c3: if random.unit() < 0.5 {
                0.0
            } else {
                random.between(0.05, 0.5)
            },
            ..Default::default()
        };
        let start = std::array::from_fn(|_| random.real(0.8));
        (model, start, random.between(4.0, 12.0))
    });
    let events = [
        "closing N",
        "opening N",
        "parting N",
        "landing F",
        "release F",
    ];
    happened(&tally, &events);
}

#[test]
fn through_a_stack_on_a_shaken_table() {
    let tally = tally(20, |random| {
        let model = Stack {
            shake: random.between(0.05, 0.4),
            omega: random.between(1.0, 3.0),
            damping: random.between(0.1, 2.0),
            loss: random.between(0.0, 0.5),
            mu: random.between(0.2, 0.8),
            ..Default::default()
        };
        let mut start = [0.2, 0.0, 0.5, 0.0, 0.0, 0.3, 0.0, -0.2, 0.0];
        for component in &mut start[..8] {
            *component += random.real(0.3);
        }
        (model, start, random.between(1.0, 4.0))
    });
    let events = ["closing T", "parting T", "closing P", "opening P"];
    happened(&tally, &events);
    happened(
        &tally,
        &["landing F", "release F", "landing G", "release G"],
    );
}

#[test]
fn through_two_round_walls() {
    let tally = tally(20, |random| {
        let model = Ball {
            left: random.between(1.0, 5.0),
            right: random.between(1.0, 5.0),
            curve: random.real(0.3),
        };
        let start = [random.real(0.4), random.between(0.6, 1.5)];
        (model, start, random.between(2.0, 6.0))
    });
    happened(
        &tally,
        &["closing L", "opening L", "closing R", "opening R"],
    );
}
