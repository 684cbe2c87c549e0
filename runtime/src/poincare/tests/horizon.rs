use std::f64::consts::{PI, TAU};

use super::{close, level, swing};
use crate::field::SmoothField;
use crate::field::exact::Mode;
use crate::flow::SmoothFlow;
use crate::flow::exact::ExactFlow;
use crate::integrate::Tolerance;
use crate::model::Model;
use crate::motion::Flow;
use crate::poincare::*;
use crate::{friction_law, model};

model! {
    /// A fast oscillation, x = cos(1231 t), beside a slow one, y = -cos(t/1000), and a drift.
    struct Scales {
        state x = 1.0;
        state v = 0.0;
        state y = -1.0;
        state w = 0.0;
        state z = 0.0;
        param fast = 1231.0;
        param slow = 1e-3;
        param drift = 1e-2;
        der(x) = fast * v;
        der(v) = -fast * x;
        der(y) = slow * w;
        der(w) = -slow * y;
        der(z) = drift;
    }
}

model! {
    /// Follows its drive at a distance.
    struct Turned {
        state x = 1.0;
        param omega = 1.0 where omega > 0.0;
        param rate = 1.0;
        drive phi at omega;
        der(x) = rate * (cos(phi) - x);
    }
}

model! {
    /// A mass between harmonic force and dry friction: it rests for a while at each end of its way.
    struct Resting {
        state x = 0.0;
        state v = 0.0;
        param beta = 0.2 where beta > 0.0;
        drive phi at beta;
        friction F = Dry { level: 0.6 } opposing v;
        der(x) = v;
        der(v) = cos(phi) - x + F;
    }
}

friction_law! {
    struct Dry {
        param level: N where level >= 0.0;
        stick = level;
        slip(s) = level + 0.0 * s;
    }
}

pub(super) fn smooth<M: Model<N>, const N: usize>(model: &M) -> SmoothFlow<M, N> {
    let field = SmoothField::new(model, None, Default::default()).unwrap();
    SmoothFlow::new(field, Tolerance::for_accuracy(1e-9))
}

/// The first crossings of a state through a level, awaited as long as one may come.
fn awaited(flow: &dyn Flow, start: &[f64], state: usize, value: f64, count: usize) -> Vec<f64> {
    let section = Section {
        surface: Surface::Level { state, value },
        direction: Direction::Up,
    };
    let place = flow.place(start).unwrap();
    let crossings = Crossings::new(flow, place, section, Horizon::Recurrence).unwrap();
    crossings
        .take(count)
        .map(|crossing| crossing.unwrap().time)
        .collect()
}

/// Why nothing comes.
fn reason(flow: &dyn Flow, start: &[f64], section: Section) -> Silence {
    let place = flow.place(start).unwrap();
    let mut crossings = Crossings::new(flow, place, section, Horizon::Recurrence).unwrap();
    assert_eq!(crossings.next(), None);
    crossings.silence().unwrap()
}

#[test]
fn fast_and_slow_sections_of_one_motion_are_both_met() {
    let model = Scales {
        slow: 0.5,
        ..Scales::default()
    };
    let (flow, start) = (smooth(&model), [1.0, 0.0, -1.0, 0.0, 0.0]);
    let period = TAU / 1231.0;
    let fast = awaited(&flow, &start, 0, 0.0, 3);
    close(&fast, &[0.75, 1.75, 2.75].map(|turns| turns * period));
    let slow = awaited(&flow, &start, 2, 0.0, 1);
    assert!((slow[0] - PI).abs() < 1e-6, "{slow:?}");
    let place = flow.place(&start).unwrap();
    let drift = Section {
        surface: Surface::Level {
            state: 4,
            value: 0.02,
        },
        direction: Direction::Both,
    };
    let met = until(&flow, place, drift, 4.0).unwrap();
    assert_eq!(met.points.len(), 1, "{met:?}");
    assert!((met.points[0].time - 2.0).abs() < 1e-9, "{met:?}");
}

/// Beside a fast mode that has died out, the norm of the Jacobian says nothing of the time that a turn takes.
#[test]
fn stiff_motions_are_watched_as_long_as_slow_ones_need() {
    for fast in [1e3, 1e6] {
        let model = Turned {
            omega: 1e-2,
            rate: fast,
        };
        let found = awaited(&smooth(&model), &[1.0, 0.0], 0, 0.0, 2);
        for (k, time) in found.iter().enumerate() {
            let expected = (1.5 * PI + k as f64 * TAU) / 1e-2 + 1.0 / fast;
            assert!((time / expected - 1.0).abs() < 1e-5, "{time} {expected}");
        }
        assert_eq!(found.len(), 2);
    }
}

#[test]
fn a_phase_is_a_stroboscope_however_slow_or_fast() {
    for omega in [1e-4, 1.0, 1e5] {
        let flow = smooth(&Turned {
            omega,
            ..Turned::default()
        });
        for phase in [0.0, 1.0, -1.0, 8.0] {
            let first = if phase == 0.0 {
                TAU
            } else {
                f64::rem_euclid(phase, TAU)
            };
            let found = awaited(&flow, &[1.0, 0.0], 1, phase, 3);
            for (k, time) in found.iter().enumerate() {
                let expected = (first + k as f64 * TAU) / omega;
                assert!((time / expected - 1.0).abs() < 1e-12, "{time} {expected}");
            }
            assert_eq!(found.len(), 3);
        }
    }
}

#[test]
fn what_is_never_met_says_why() {
    let far = Section {
        surface: Surface::Level {
            state: 0,
            value: 2.0,
        },
        direction: Direction::Both,
    };
    let silence = reason(&swing(), &[1.0, 0.0], far);
    assert_eq!(silence.reason, Reason::Bounded);
    assert!((silence.low[0] + 1.0).abs() < 1e-9 && (silence.high[0] - 1.0).abs() < 1e-9);
    assert!(silence.steps < 100_000, "{silence:?}");
    let touched = Section {
        surface: Surface::Level {
            state: 0,
            value: 1.0,
        },
        direction: Direction::Both,
    };
    assert_eq!(
        reason(&swing(), &[0.0, 1.0], touched).reason,
        Reason::Bounded
    );
    let driven = reason(&smooth(&Turned::default()), &[1.0, 0.0], far);
    assert_eq!(driven.reason, Reason::Bounded);
    let drifting = Section {
        surface: Surface::Rate(4),
        direction: Direction::Both,
    };
    let silence = reason(
        &smooth(&Scales::default()),
        &[1.0, 0.0, -1.0, 0.0, 0.0],
        drifting,
    );
    assert_eq!(silence.reason, Reason::Long);
}

/// The speed comes to zero, stays there, and goes on to the other side: it has crossed when it came.
#[test]
fn a_level_on_which_a_state_rests_is_crossed_on_arrival() {
    let flow = ExactFlow::new(
        &Resting::default(),
        None,
        Tolerance::for_accuracy(1e-9).explicit(),
    );
    let flow = flow.unwrap();
    let place = Flow::place(&flow, &[0.0, 0.0, 0.0]).unwrap();
    let met = until(&flow, place.clone(), level(0.0, Direction::Both), 100.0).unwrap();
    let passage = Flow::advance(&flow, &place, 100.0, Default::default()).unwrap();
    let sticks = |modes: &[Mode]| modes == [Mode::Stick];
    let mut time = 0.0;
    let mut arrivals = Vec::new();
    for segment in &passage.segments {
        if sticks(&segment.modes) && time > 0.0 {
            arrivals.push(time);
        }
        time += segment.duration;
    }
    let found: Vec<f64> = met.points.iter().map(|point| point.time).collect();
    assert!(found.len() > 4, "{found:?}");
    for arrival in &found {
        let near = arrivals.iter().any(|time| (time - arrival).abs() < 1e-7);
        assert!(near, "{arrival} is none of {arrivals:?}");
    }
}
