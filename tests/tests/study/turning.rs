//! A machine whose first state is an angle, the halves of whose turn mirror each other.

use std::f64::consts::TAU;

use stickslip::field::Design;
use stickslip::model;
use stickslip::model::Model as _;
use stickslip::poincare::Surface;
use stickslip::study::{
    Along, Case, Class, Diagram, Dynamics, Motion, Region, Sampling, Side, Sweep, System,
};
use stickslip_models::friction::Coulomb;

model! {
    /// A crank and a slider on a dry guide, turned by a motor whose torque falls with its speed.
    pub struct Crank {
        state a: rad = 0.0;
        state w: rad/s = 5.0;
        param inertia: kg*m^2 = 0.02 where inertia > 0.0;
        param mass: kg = 2.0 where mass > 0.0;
        param r: m = 0.1 where r > 0.0;
        param dry: N = 8.0 where dry >= 0.0;
        param stall: N*m = 2.0;
        param fall: N*m*s/rad = 0.2;
        friction F: N = Coulomb { level: dry } opposing -r * sin(a) * w;
        let swing = mass * r * r * sin(a);
        der(a) = w;
        der(w) = (stall - fall * w - F * r * sin(a) - swing * cos(a) * w * w) / (inertia + swing * sin(a));
    }
}

/// The period of a whole turn: d(w, t)/da over half a turn, to thirteen digits.
const PERIOD: f64 = 0.857_274_694_976;

fn crank(along: Option<(usize, f64, f64)>) -> (System, Case) {
    let mut case = Case::declared(Crank::INFO, Dynamics::Exact);
    if let Some((parameter, from, to)) = along {
        let design = Design::Parameter(parameter);
        case.along = Some(Along { design, from, to });
        case = case.at(from);
    }
    (System::of::<Crank, _>(), case)
}

/// Half a turn on, everything is as it was, but the slider goes the other way.
#[test]
fn half_a_turn_is_no_period_where_contacts_slide_the_other_way() {
    let (system, case) = crank(None);
    let orbit = system.orbit(&case).unwrap();
    assert!((orbit.period / PERIOD - 1.0).abs() < 1e-9, "{orbit:?}");
    assert!((orbit.shift.as_ref().unwrap()[0] - TAU).abs() < 1e-9);
    let branch = system.branch(&crank(Some((Crank::dry.index, 8.0, 0.5))).1);
    let branch = branch.unwrap();
    assert!(branch.ended.is_whole(), "{}", branch.ended.reason);
}

/// The guide holds what the motor cannot overcome at its best lever: r dry = 0.8 N m.
#[test]
fn what_lasts_as_the_inverse_root_of_a_distance_ends_there() {
    let (system, case) = crank(Some((Crank::stall.index, 2.0, 0.5)));
    let ended = system.branch(&case).unwrap().ended;
    let told = "it grows without bound towards 0.8";
    assert_eq!(ended.reason, told);
}

#[test]
fn the_turns_of_another_state_make_the_section_where_the_first_runs_on() {
    let (system, case) = crank(Some((Crank::stall.index, 1.0, 2.0)));
    let section = system.section(&case).unwrap();
    assert_eq!(section.surface, Surface::Rate(1));
    let diagram = Diagram {
        section,
        sweep: Sweep::Up,
        values: 3,
        settle: 50,
        points: 16,
        lyapunov: None,
    };
    let record = system.diagram(&case, &diagram).unwrap();
    for slice in &record.sweeps[0].slices {
        assert_eq!(slice.motion, Motion::Periodic(2), "{}", slice.r);
    }
}

#[test]
fn what_turns_and_mirrors_itself_is_one_attractor() {
    let (system, case) = crank(None);
    let side = |state, low, high| Side { state, low, high };
    let sides = vec![side(0, -3.0, 3.0), side(1, 1.0, 8.0)];
    let record = system.attractors(&case, &Sampling::of(Region { sides }, 10));
    let found = &record.unwrap().surveys[0].found;
    assert_eq!(found.len(), 1);
    let turning = &found[0].attractor;
    assert_eq!(turning.class, Class::Running);
    assert!((turning.period.unwrap() / PERIOD - 1.0).abs() < 1e-6);
}
