mod horizon;
mod inside;

use std::f64::consts::{FRAC_PI_6, PI, TAU};

use super::*;
use crate::examples::Belt;
use crate::field::SmoothField;
use crate::flow::SmoothFlow;
use crate::flow::exact::ExactFlow;
use crate::integrate::Tolerance;
use crate::model;

model! {
    /// x = cos t from its declared start.
    struct Swing {
        state x = 1.0;
        state v = 0.0;
        param k = 1.0;
        der(x) = v;
        der(v) = -k * x;
    }
}

fn swing() -> SmoothFlow<Swing, 2> {
    let field = SmoothField::new(&Swing::default(), None, Default::default()).unwrap();
    SmoothFlow::new(field, Tolerance::for_accuracy(1e-11))
}

fn level(value: f64, direction: Direction) -> Section {
    Section {
        surface: Surface::Level { state: 1, value },
        direction,
    }
}

fn times(section: Section, time: f64) -> Vec<f64> {
    let flow = swing();
    let start = flow.place(&[1.0, 0.0]).unwrap();
    let met = until(&flow, start, section, time).unwrap();
    met.points.iter().map(|crossing| crossing.time).collect()
}

fn close(found: &[f64], expected: &[f64]) {
    let near = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-9;
    assert_eq!(found.len(), expected.len(), "{found:?}");
    assert!(
        found.iter().zip(expected).all(near),
        "{found:?}, not {expected:?}"
    );
}

/// v = −sin t is 1/2 at 7π/6, rising no more than it did at first, and at 11π/6.
#[test]
fn levels_are_met_where_the_sine_says() {
    close(
        &times(level(0.5, Direction::Down), TAU),
        &[11.0 * FRAC_PI_6],
    );
    close(&times(level(0.5, Direction::Up), TAU), &[7.0 * FRAC_PI_6]);
    let both = times(level(0.5, Direction::Both), 2.0 * TAU);
    let expected = [7.0, 11.0, 19.0, 23.0].map(|k| k * FRAC_PI_6);
    close(&both, &expected);
    close(&times(level(1.5, Direction::Both), TAU), &[]);
}

/// However near the level is to the crest, both crossings are there.
#[test]
fn crossings_next_to_each_other_are_told_apart() {
    for gap in [1e-3_f64, 1e-6, 1e-9] {
        let found = times(level(1.0 - gap, Direction::Both), 5.0 * TAU);
        assert_eq!(found.len(), 10, "at {gap:e}: {found:?}");
        let half = (1.0 - gap).acos();
        assert!((found[1] - found[0] - 2.0 * half).abs() < 1e-4 * half.max(1e-4));
    }
}

#[test]
fn the_default_section_is_where_the_first_state_is_least() {
    close(
        &times(Section::default(), 5.5 * PI),
        &[PI, 3.0 * PI, 5.0 * PI],
    );
}

#[test]
fn an_orbit_that_begins_on_its_section_meets_it_once() {
    let flow = swing();
    let down = Section {
        direction: Direction::Down,
        ..Section::default()
    };
    for shift in [0.0, 1e-9, -1e-9, 0.3] {
        let start = flow.place(&[f64::cos(shift), -f64::sin(shift)]).unwrap();
        let found = once_around(&flow, start, down, TAU).unwrap().points;
        assert_eq!(found.len(), 1, "from {shift}: {found:?}");
    }
}

/// A mass that is carried by the belt has its speed for a while and goes no faster.
#[test]
fn a_level_that_is_only_touched_is_not_crossed() {
    let belt = Belt::default();
    let flow = ExactFlow::new(&belt, None, Tolerance::for_accuracy(1e-9).explicit()).unwrap();
    let start = flow.place(&[0.0, 0.0]).unwrap();
    let found = until(
        &flow,
        start.clone(),
        level(belt.v_dr, Direction::Both),
        60.0,
    )
    .unwrap()
    .points;
    assert!(found.is_empty(), "{found:?}");
    let below = until(&flow, start, level(0.5 * belt.v_dr, Direction::Up), 60.0).unwrap();
    let below = below.points;
    assert!(below.len() > 2, "{below:?}");
}

#[test]
fn a_motion_at_rest_crosses_nothing() {
    let flow = swing();
    let start = flow.place(&[0.0, 0.0]).unwrap();
    let mut crossings =
        Crossings::new(&flow, start, Section::default(), Horizon::Recurrence).unwrap();
    assert_eq!(crossings.next(), None);
    assert_eq!(crossings.silence().unwrap().reason, Reason::Rest);
}

fn points(values: &[f64]) -> Vec<Vec<f64>> {
    values.iter().map(|value| vec![*value]).collect()
}

#[test]
fn recurrence_is_the_least_number_that_repeats() {
    let after = |values: &[f64], extent: f64| recurrence(&points(values), &[extent], None, 1e-6);
    assert_eq!(after(&[1.0, 2.0, 1.0, 3.0].repeat(3), 2.0), Some(4));
    assert_eq!(after(&[1.0, 1.0, 1.0], 1.0), Some(1));
    assert_eq!(after(&[1.0, 2.0, 4.0], 3.0), None);
    assert_eq!(after(&[], 1.0), None);
}

/// A decaying alternation comes back to nearly the same point every second time, but not to the first.
#[test]
fn what_still_settles_has_not_come_back() {
    let points: Vec<Vec<f64>> = (0..64).map(|k| vec![(-0.99_f64).powi(k) * 1e-4]).collect();
    assert_eq!(recurrence(&points, &[1.0], None, 1e-5), None);
    assert_eq!(recurrence(&points, &[1.0], None, 1e-3), Some(1));
    assert!(approaches(&points, &[1.0], None, None));
    assert!(approaches(&points, &[1.0], None, Some(2)));
}

/// A resonator that rings down over many turns of its drive, by 0.8 percent and 2.3 degrees in each.
#[test]
fn what_turns_about_a_motion_approaches_it() {
    let point = |k: i32| {
        let (size, angle) = (0.1 * 0.992_f64.powi(k), 0.04 * f64::from(k));
        vec![size * angle.cos(), size * angle.sin()]
    };
    let points: Vec<Vec<f64>> = (0..64).map(point).collect();
    assert!(approaches(&points, &[1.0, 1.0], None, None));
}

#[test]
fn what_drifts_or_roams_approaches_nothing() {
    let drifts: Vec<f64> = (0..64).map(|k| 1e-3 * f64::from(k)).collect();
    assert!(!approaches(&points(&drifts), &[1.0], None, None));
    let mut x = 0.3;
    let roams: Vec<f64> = (0..64)
        .map(|_| {
            x = 3.9 * x * (1.0 - x);
            x
        })
        .collect();
    assert!(!approaches(&points(&roams), &[1.0], None, None));
}
