//! Poincaré diagrams against single orbits, known flips and each other.

use std::ops::ControlFlow;

use stickslip::model;
use stickslip::poincare::{Direction, Section, Surface};
use stickslip::study::{
    Along, Case, Diagram, DiagramRecord, Dynamics, Item, List, Motion, Slice, Span, Sweep, System,
};
use stickslip_models::friction::Weakening;
use stickslip_models::systems;
use stickslip_tests::range::range;

use crate::orbits::TwoCircles;

model! {
    /// A string that is bowed near its end, in two modes.
    struct Bowed {
        state p = 0.0;
        state q = 0.0;
        state vp = 0.0;
        state vq = 0.0;
        param bow = 0.75;
        let s1 = sin(0.13 * 3.141592653589793);
        let s2 = sin(0.26 * 3.141592653589793);
        friction F = Weakening { limit: 1.0, decay: 5.0 } opposing s1 * vp + s2 * vq - bow;
        der(p) = vp;
        der(q) = vq;
        der(vp) = s1 * F - p - 0.02 * vp;
        der(vq) = s2 * F - 4.0 * q - 0.04 * vq;
    }
}

const IN_PHASE: [f64; 4] = [-0.5976, 0.0, -0.4604, -0.1607];

fn case(model: &System, dynamics: Dynamics, along: Along) -> Case {
    let mut case = Case::declared(model.info(), dynamics);
    case.along = Some(along);
    case.at(along.from)
}

const USUAL: Diagram = Diagram {
    section: Section {
        surface: Surface::Rate(0),
        direction: Direction::Up,
    },
    sweep: Sweep::Fresh,
    values: 2,
    settle: 400,
    points: 32,
    lyapunov: None,
};

fn draw(model: &System, case: &Case, diagram: Diagram) -> DiagramRecord {
    model.diagram(case, &diagram).expect("a diagram")
}

fn slices(record: &DiagramRecord, sweep: usize) -> &[Slice] {
    &record.sweeps[sweep].slices
}

fn belt_pair(from: f64, to: f64) -> (System, Case) {
    let model = systems::belt_pair();
    let along = range(&model, "v_dr", from, to);
    let mut case = case(&model, Dynamics::Exact, along);
    case.start = Some(IN_PHASE.to_vec());
    (model, case)
}

/// The flips of the in-phase orbit lie at 0.0840914 and 0.1442519.
#[test]
#[ignore = "long"]
fn points_double_where_the_orbit_flips() {
    let (model, case) = belt_pair(0.142, 0.1465);
    let record = draw(
        &model,
        &case,
        Diagram {
            settle: 1500,
            ..USUAL
        },
    );
    let motions: Vec<&Motion> = slices(&record, 0).iter().map(|s| &s.motion).collect();
    assert_eq!(motions, [&Motion::Periodic(1), &Motion::Periodic(2)]);
    let (model, case) = belt_pair(0.0865, 0.12);
    let record = draw(
        &model,
        &case,
        Diagram {
            settle: 1500,
            ..USUAL
        },
    );
    for slice in slices(&record, 0) {
        assert_eq!(slice.motion, Motion::Periodic(1), "at {}", slice.r);
    }
}

/// What is seen at a value is the orbit that shooting finds there, and contracts as its multipliers say.
fn a_slice_is_the_orbit(dynamics: Dynamics) {
    let (model, mut case) = belt_pair(0.12, 0.125);
    case.dynamics = dynamics;
    let diagram = Diagram {
        settle: 600,
        lyapunov: Some(40),
        ..USUAL
    };
    let record = draw(&model, &case, diagram);
    for slice in slices(&record, 0) {
        let orbit = model
            .orbit(&Case {
                along: None,
                ..case.at(slice.r)
            })
            .unwrap();
        assert_eq!(slice.motion, Motion::Periodic(orbit.period_count));
        for (found, shot) in slice.points[31].iter().zip(&orbit.state) {
            assert!((found - shot).abs() < 1e-7, "{found} {shot}");
        }
        for j in 0..4 {
            assert!((slice.max[j] - orbit.max[j]).abs() < 1e-7);
            assert!((slice.min[j] - orbit.min[j]).abs() < 1e-7);
        }
        let exponent = slice.lyapunov.as_ref().unwrap().as_ref().unwrap();
        let expected = orbit.floquet.log_moduli[0].unwrap() / orbit.period;
        let value = exponent.exponent.unwrap();
        assert!((value / expected - 1.0).abs() < 1e-5, "{value} {expected}");
    }
}

#[test]
fn a_slice_is_the_orbit_that_shooting_finds() {
    a_slice_is_the_orbit(Dynamics::Exact);
}

#[test]
#[ignore = "long"]
fn a_slice_of_a_copy_is_the_orbit_that_shooting_finds() {
    a_slice_is_the_orbit(Dynamics::Smoothed("tanh:1e4".parse().unwrap()));
}

/// The largest exponent of a mass that sticks is −∞; of its smooth copy, Liouville tells it.
#[test]
fn one_mass_is_superstable_and_its_copy_nearly() {
    let model = systems::belt_oscillator();
    let along = range(&model, "v_dr", 0.2, 0.25);
    let diagram = Diagram {
        settle: 5,
        lyapunov: Some(4),
        ..USUAL
    };
    let copy = Dynamics::Smoothed("arctan:1e3".parse().unwrap());
    let exponent = |dynamics| {
        let case = case(&model, dynamics, along);
        let record = draw(&model, &case, diagram);
        let slice = slices(&record, 0)[0].clone();
        let orbit = model
            .orbit(&Case {
                along: None,
                ..case
            })
            .unwrap();
        (slice.lyapunov.unwrap().unwrap().exponent, orbit)
    };
    assert_eq!(exponent(Dynamics::Exact).0, None);
    let (found, orbit) = exponent(copy);
    let expected = orbit.floquet.log_moduli[0].unwrap() / orbit.period;
    assert!((found.unwrap() / expected - 1.0).abs() < 1e-6);
}

/// Down from the large circle, the motion stays on it to the fold at p = −1; up from the origin, it rests to p = 0.
#[test]
#[ignore = "long"]
fn sweeps_stay_with_their_attractor() {
    let model = System::of::<TwoCircles, _>();
    let case = case(&model, Dynamics::Smooth, range(&model, "p", -1.505, 0.495));
    let diagram = Diagram {
        sweep: Sweep::Both,
        values: 101,
        settle: 60,
        points: 8,
        ..USUAL
    };
    let record = draw(&model, &case, diagram);
    let swings = |slice: &&Slice| slice.motion == Motion::Periodic(1);
    let up: Vec<&Slice> = slices(&record, 0).iter().filter(swings).collect();
    let down: Vec<&Slice> = slices(&record, 1).iter().filter(swings).collect();
    assert_eq!(
        (record.sweeps[0].name, record.sweeps[1].name),
        ("up", "down")
    );
    let first = up.first().unwrap().r;
    assert!(first > 0.0 && first < 0.2, "up it leaves rest at {first}");
    let last = down.last().unwrap().r;
    assert!(last > -1.0 && last < -0.96, "down it is lost at {last}");
    for slice in down {
        let radius = (1.0 + (1.0 + slice.r).sqrt()).sqrt();
        assert!((slice.points[0][0] + radius).abs() < 1e-5, "{}", slice.r);
    }
}

/// Any section of a periodic motion is crossed as often up as down, and `orbit` counts the default one.
#[test]
fn sections_of_an_orbit_agree_with_its_count() {
    let (model, case) = belt_pair(0.146, 0.147);
    let case = Case {
        along: None,
        ..case
    };
    let orbit = model.orbit(&case).unwrap();
    let from = Case {
        start: Some(orbit.state.clone()),
        ..case
    };
    let count = |surface, direction| {
        let section = Section { surface, direction };
        let span = Span::Period(orbit.period);
        let met = model.crossings(&from, section, span).unwrap();
        met.points.len()
    };
    let default = count(Surface::Rate(0), Direction::Up);
    assert_eq!(default, orbit.period_count);
    for j in 0..4 {
        let value = 0.5 * (orbit.min[j] + orbit.max[j]) + 0.01;
        for surface in [Surface::Rate(j), Surface::Level { state: j, value }] {
            let (up, down) = (
                count(surface, Direction::Up),
                count(surface, Direction::Down),
            );
            assert!(up > 0 && up == down, "state {j}: {up} up, {down} down");
            assert_eq!(count(surface, Direction::Both), up + down);
        }
    }
}

fn threads_change_no_bit(values: usize, others: &[Option<usize>]) {
    let (model, case) = belt_pair(0.2, 0.3);
    for sweep in [Sweep::Fresh, Sweep::Both] {
        let with = |threads| {
            let diagram = Diagram {
                sweep,
                values,
                settle: 20,
                points: 12,
                lyapunov: Some(20),
                ..USUAL
            };
            let list = List {
                threads,
                ..List::default()
            };
            let go_on = |_: Item<'_, Slice>| ControlFlow::Continue(());
            let record = model.diagram_watched(&case, &diagram, &list, &go_on);
            record.expect("a diagram").sweeps
        };
        let one = with(Some(1));
        for &threads in others {
            assert_eq!(one, with(threads), "{threads:?}");
        }
    }
}

#[test]
fn two_threads_change_no_bit() {
    threads_change_no_bit(2, &[Some(2)]);
}

#[test]
#[ignore = "long"]
fn the_number_of_threads_changes_no_bit() {
    threads_change_no_bit(9, &[Some(2), Some(8), None]);
}

#[test]
fn a_value_without_an_answer_does_not_stop_the_others() {
    let model = systems::belt_oscillator();
    let along = range(&model, "v_dr", -0.1, 0.1);
    let record = draw(
        &model,
        &case(&model, Dynamics::Exact, along),
        Diagram {
            values: 5,
            settle: 5,
            ..USUAL
        },
    );
    assert_eq!(slices(&record, 0).len(), 5);
    assert_eq!(slices(&record, 0)[2].motion, Motion::Rest, "v_dr = 0");
    assert_eq!(slices(&record, 0)[4].motion, Motion::Periodic(1));
}

model! {
    /// A light mass on a spring beside a drive: what it begins with dies by a fortieth each turn.
    pub struct Light {
        state x = 0.0;
        state v = 0.0;
        param damping = 0.008;
        param load = 1.0;
        param omega = 2.0 where omega > 0.0;
        drive phi at omega;
        der(x) = v;
        der(v) = load * cos(phi) - x - damping * 2.0 * v;
    }
}

/// A motion that still comes nearer to where it settles is given time: it is not aperiodic.
#[test]
fn what_settles_slowly_is_waited_for() {
    let model = System::of::<Light, _>();
    let along = range(&model, "load", 1.0, 2.0);
    let case = case(&model, Dynamics::Smooth, along);
    let section = Section::usual(model.info().drive);
    let diagram = Diagram {
        section,
        settle: 100,
        points: 64,
        ..USUAL
    };
    for slice in slices(&draw(&model, &case, diagram), 0) {
        assert_eq!(slice.motion, Motion::Periodic(1), "{}", slice.r);
        let amplitude = slice.r / 3.0_f64.hypot(0.032);
        let off = (slice.max[0] / amplitude - 1.0).abs();
        assert!(off < 1e-3, "{off}");
    }
}

/// While it is drawn, the motion passes by where an orbit nearly was, and does not come back: but motions beside it come to it.
#[test]
fn what_attracts_and_has_not_come_back_is_settling() {
    let model = System::of::<Bowed, _>();
    let case = case(&model, Dynamics::Exact, range(&model, "bow", 0.76, 0.75));
    let first = |settle| {
        let diagram = Diagram {
            settle,
            points: 64,
            sweep: Sweep::Down,
            lyapunov: Some(300),
            ..USUAL
        };
        slices(&draw(&model, &case, diagram), 0)[0].clone()
    };
    let passing = first(300);
    let exponent = passing.lyapunov.expect("asked for").expect("a value");
    assert!(exponent.attracts(), "{exponent:?}");
    assert_eq!(passing.motion, Motion::Settling);
    assert_eq!(first(2000).motion, Motion::Periodic(1));
}
