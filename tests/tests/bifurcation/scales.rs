//! Sections and diagrams of motions that are fast, slow, or both, and of those that never come.

use std::f64::consts::{PI, TAU};

use stickslip::model;
use stickslip::poincare::{Direction, Reason, Section, Surface};
use stickslip::study::{Case, Diagram, Dynamics, Motion, Slice, Span, Sweep, System};
use stickslip_models::friction::Tustin;
use stickslip_tests::range::{place, range};

model! {
    /// A bowed string in three modes, the lowest at 1231.5 rad/s.
    struct Bowed {
        state q[3]: m = 0.0;
        state p[3]: m/s = 0.0;
        param omega: rad/s = 1231.5 where omega > 0.0;
        param zeta: 1 = 0.002 where zeta >= 0.0;
        param mass: kg = 0.0002 where mass > 0.0;
        param beta: 1 = 0.12 where 0.0 < beta < 1.0;
        param bow: m/s = 0.1;
        param pressed: N = 1.0 where pressed >= 0.0;
        for i in 0..3 {
            let shape[i] = sin((i + 1) * std::f64::consts::PI * beta);
        }
        let string = shape[0] * p[0] + shape[1] * p[1] + shape[2] * p[2];
        friction F: N = Tustin { static_level: 0.8 * pressed, kinetic_level: 0.3 * pressed, speed: 0.1, viscous: 0.0 } opposing string - bow;
        for i in 0..3 {
            der(q[i]) = p[i];
            der(p[i]) = F * shape[i] / mass - 2 * zeta * (i + 1) * omega * p[i] - powi((i + 1) * omega, 2) * q[i];
        }
    }
}

model! {
    /// A Van der Pol oscillator at `fast`, and a slow harmonic one beside it.
    struct Apart {
        state x = 1.0;
        state v = 0.0;
        state y = 1.0;
        state w = 0.0;
        param fast = 3000.0 where fast > 0.0;
        param slow = 2.0 where slow > 0.0;
        der(x) = fast * v;
        der(v) = fast * ((1 - powi(x, 2)) * v - x);
        der(y) = slow * w;
        der(w) = -slow * y;
    }
}

const USUAL: Diagram = Diagram {
    section: Section {
        surface: Surface::Rate(0),
        direction: Direction::Up,
    },
    sweep: Sweep::Fresh,
    values: 2,
    settle: 20,
    points: 16,
    lyapunov: None,
};

fn level(state: usize, value: f64) -> Section {
    Section {
        surface: Surface::Level { state, value },
        direction: Direction::Up,
    }
}

fn slices(model: &System, name: &str, (from, to): (f64, f64), diagram: Diagram) -> Vec<Slice> {
    let dynamics = if model.info().contacts.is_empty() {
        Dynamics::Smooth
    } else {
        Dynamics::Exact
    };
    let mut case = Case::declared(model.info(), dynamics);
    case.along = Some(range(model, name, from, to));
    let case = case.at(from);
    let record = model.diagram(&case, &diagram);
    record.expect("a diagram").sweeps[0].slices.clone()
}

/// As often as the sampled motion itself goes through the level.
#[test]
fn all_crossings_of_a_fast_string_are_found() {
    let model = System::of::<Bowed, _>();
    let case = Case::declared(model.info(), Dynamics::Exact);
    let motion = model.motion(&case, 0.2).expect("a motion");
    let speeds: Vec<f64> = motion.states.iter().map(|state| state[3]).collect();
    let rises = speeds
        .windows(2)
        .filter(|pair| pair[0] < 0.0 && pair[1] >= 0.0);
    let met = model
        .crossings(&case, level(3, 0.0), Span::Time(0.2))
        .expect("crossings");
    assert_eq!(met.points.len(), rises.count());
    assert_eq!(met.points.len(), 39);
    assert!(met.against.abs_diff(39) <= 1);
}

#[test]
fn a_diagram_of_a_fast_string_has_its_points() {
    let model = System::of::<Bowed, _>();
    for slice in slices(&model, "pressed", (0.2, 5.0), USUAL) {
        assert_eq!(slice.points.len(), 16, "{:?}", slice.motion);
        assert!(slice.silence.is_none());
    }
}

/// A section of the fast oscillation and one of the slow one, each beside the other.
#[test]
fn both_time_scales_of_one_model_have_their_diagrams() {
    let model = System::of::<Apart, _>();
    let few = Diagram {
        settle: 2,
        points: 2,
        ..USUAL
    };
    let fast = slices(
        &model,
        "slow",
        (1.0, 2.0),
        Diagram {
            section: level(0, 0.0),
            ..few
        },
    );
    assert!(fast.iter().all(|slice| slice.points.len() == 2), "{fast:?}");
    let case = Case::declared(model.info(), Dynamics::Smooth);
    let met = model
        .crossings(&case, level(2, 0.0), Span::Time(10.0))
        .expect("crossings");
    let times: Vec<f64> = met.points.iter().map(|point| point.time).collect();
    let expected: Vec<f64> = (0..3)
        .map(|k| (1.5 * PI + TAU * f64::from(k)) / 2.0)
        .collect();
    assert_eq!(times.len(), 3, "{times:?}");
    for (time, expected) in times.iter().zip(&expected) {
        assert!((time - expected).abs() < 1e-7, "{times:?}");
    }
}

/// A level out of reach, one that is touched at the crest, and a state that only grows.
#[test]
fn what_is_elsewhere_says_where() {
    let model = System::of::<Apart, _>();
    let calm = Diagram {
        section: level(0, 7.0),
        ..USUAL
    };
    for slice in slices(&model, "slow", (1000.0, 2000.0), calm) {
        assert_eq!(slice.motion, Motion::Elsewhere);
        let silence = slice.silence.expect("a reason");
        assert_eq!(silence.reason, Reason::Bounded);
        assert!(
            silence.low[0] < -2.0 && silence.high[0] > 2.0,
            "{silence:?}"
        );
        assert!(silence.high[0] < 2.1 && silence.time > 0.02, "{silence:?}");
    }
    let mut case = Case::declared(model.info(), Dynamics::Smooth);
    case.parameters[place(&model, "fast")] = 1.0;
    let met = model
        .crossings(&case, level(2, 1.0), Span::Time(20.0))
        .expect("crossings");
    assert!(met.points.is_empty(), "{met:?}");
    assert!((met.high[2] - 1.0).abs() < 1e-9);
}

model! {
    /// A plate on a spring that a voltage draws towards another, in metres and newtons.
    struct Actuator {
        state x: m = 1e-8;
        state v: m/s = 0.0;
        param m: kg = 1e-10 where m > 0.0;
        param k: N/m = 10.0 where k > 0.0;
        param c: N*s/m = 1e-6 where c >= 0.0;
        param gap: m = 2e-6 where gap > 0.0;
        param plate: F*m = 8.854e-20 where plate > 0.0;
        param voltage: V = 10.0;
        der(x) = v;
        der(v) = (0.5 * plate * voltage * voltage / powi(gap - x, 2) - k * x - c * v) / m;
    }
}

/// k x (g − x)² = ε A U²/2 has one root below g/3, where its left side is largest, and one up to g: places are tried as far away as those
/// show that are found, and a branch begins at the one next to its start.
#[test]
fn equilibria_of_micrometres_are_found() {
    let model = Actuator::default();
    let Actuator {
        k,
        gap,
        plate,
        voltage,
        ..
    } = model;
    let pull = 0.5 * plate * voltage * voltage / k;
    let root = |mut below: f64, mut above: f64| {
        for _ in 0..200 {
            let middle = 0.5 * (below + above);
            match middle * (gap - middle).powi(2) < pull {
                true => below = middle,
                false => above = middle,
            }
        }
        below
    };
    let (system, case) = (System::of::<Actuator, _>(), Case::of(&model));
    let found = system.equilibria(&case).unwrap();
    for x in [root(0.0, gap / 3.0), root(gap, gap / 3.0)] {
        let near = |at: f64| (at / x - 1.0).abs() < 1e-9;
        assert!(
            found.iter().any(|one| near(one.state[0])),
            "{x:e} {found:?}"
        );
        let mut case = case.clone().following(Actuator::voltage, 10.0..11.0);
        case.start = Some(vec![1.001 * x, 0.0]);
        let branch = system.equilibria_along(&case).unwrap();
        assert!(
            near(branch.points[0].state[0]),
            "{x:e} {:?}",
            branch.points[0]
        );
    }
}
