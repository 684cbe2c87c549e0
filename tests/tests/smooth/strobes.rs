//! Driven motions on their stroboscope, and the motion on which a start settles.

use stickslip::model;
use stickslip::poincare::{Direction, Section, Surface};
use stickslip::study::{Case, Diagram, Dynamics, Motion, Slice, Sweep, System};
use stickslip_models::friction::PoppStelter as Law;
use stickslip_models::systems;
use stickslip_tests::range::{place, range};

model! {
    /// A friction oscillator on a belt, its support shaken: Popp and Stelter 1990.
    struct Popp {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param m: kg = 1.0 where m > 0.0;
        param k: N/m = 1.0 where k > 0.0;
        param belt: m/s = 1.0;
        param u0: m = 0.5;
        param Omega: rad/s = 0.6 where Omega > 0.0;
        param normal: N = 10.0 where normal >= 0.0;
        drive phi at Omega;
        friction F: N = Law { static_level: 0.4 * normal, kinetic_level: 0.1 * normal, decay: 1.42, growth: 0.01 * normal } opposing v - belt;
        der(x) = v;
        der(v) = (F - k * (x - u0 * cos(phi))) / m;
    }
}

model! {
    /// Rössler's band.
    struct Band {
        state x = 1.0;
        state y = 1.0;
        state z = 0.0;
        param c = 5.3;
        der(x) = -y - z;
        der(y) = x + 0.2 * y;
        der(z) = 0.2 + z * (x - c);
    }
}

fn level(state: usize, value: f64) -> Section {
    Section {
        surface: Surface::Level { state, value },
        direction: Direction::Up,
    }
}

/// The slice of a model at these parameters, on this section.
fn slice(model: &System, set: &[(&str, f64)], section: Section) -> Slice {
    let mut case = Case::declared(model.info(), Dynamics::Exact);
    for (name, value) in set {
        case.parameters[place(model, name)] = *value;
    }
    let (name, value) = set[0];
    case.along = Some(range(model, name, value, value * 1.0001));
    let diagram = Diagram {
        section,
        sweep: Sweep::Fresh,
        values: 2,
        settle: 200,
        points: 32,
        lyapunov: None,
    };
    let record = model.diagram(&case, &diagram);
    record.expect("a diagram").sweeps[0].slices[0].clone()
}

/// Whatever the section: the n of a driven motion is that of its drive.
#[test]
fn driven_motions_are_counted_in_turns_of_the_drive() {
    let model = System::of::<Popp, _>();
    let set = [("u0", 5.0), ("Omega", 1.0)];
    let sections = [
        Section::usual(model.info().drive),
        level(2, 1.0),
        level(1, 0.0),
        Section::default(),
    ];
    for section in sections {
        let slice = slice(&model, &set, section);
        assert_eq!(slice.motion, Motion::Periodic(1), "{section:?}");
        for point in &slice.points {
            assert!(
                (0.0..std::f64::consts::TAU).contains(&point[2]),
                "{point:?}"
            );
        }
    }
    let both = Section {
        direction: Direction::Both,
        ..level(1, 0.0)
    };
    let twice = slice(&model, &set, both);
    assert_eq!((twice.motion, twice.different), (Motion::Periodic(1), 2));
}

#[test]
fn two_turns_of_the_drive_are_a_period_of_two() {
    let model = systems::forced_belt();
    let set = [("load", 0.4), ("omega", 0.5), ("delta", 3.0)];
    let found = slice(&model, &set, Section::usual(model.info().drive));
    assert_eq!((found.motion, found.different), (Motion::Periodic(2), 2));
    let expected = [1.665_441_136_519, 0.110_633_744_667];
    for point in &found.points[..2] {
        let near = expected.iter().any(|x| (point[0] - x).abs() < 1e-8);
        assert!(near, "{point:?}");
    }
}

/// In windows of the band motions of long periods are stable, and so are not the shorter ones through which they pass.
#[test]
fn a_start_gives_the_motion_on_which_it_settles() {
    let model = System::of::<Band, _>();
    for (c, count) in [(2.5, 1), (3.5, 2), (5.3, 3), (4.875, 7), (4.72, 20)] {
        let mut case = Case::declared(model.info(), Dynamics::Smooth);
        case.parameters[0] = c;
        for start in [[1.0, 1.0, 0.0], [-2.0, 4.0, 0.1]] {
            case.start = Some(start.to_vec());
            let orbit = model.orbit(&case).expect("the motion that stays");
            assert_eq!(orbit.floquet.stability.name(), "stable", "{c}");
            assert_eq!(orbit.period_count, count, "{c} from {start:?}");
        }
    }
}

/// A start that lies on an unstable orbit is meant to be there.
#[test]
fn a_start_on_an_unstable_orbit_is_that_orbit() {
    let model = System::of::<Band, _>();
    let mut case = Case::declared(model.info(), Dynamics::Smooth);
    case.parameters[0] = 3.5;
    case.start = Some(vec![-3.0, -3.0, 0.03]);
    case.period = Some(5.9);
    let once = model.orbit(&case).expect("the unstable one");
    assert_eq!(
        (once.period_count, once.floquet.stability.name()),
        (1, "unstable")
    );
    case.start = Some(once.state.clone());
    case.period = None;
    let again = model.orbit(&case).expect("the same");
    assert!(
        (again.period - once.period).abs() < 1e-8,
        "{}",
        again.period
    );
}
