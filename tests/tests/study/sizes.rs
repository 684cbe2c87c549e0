//! Motions whose states are small: errors are measured against how large they are, whatever their units.

use stickslip::field::Design;
use stickslip::model;
use stickslip::poincare::{Direction, Section, Surface};
use stickslip::study::{Along, Case, Dynamics, Span, System};

model! {
    /// A beam of nanometres that swings a hundred and sixty times a second.
    pub struct Tiny {
        state x: m = 5e-9;
        state v: m/s = 0.0;
        param omega: rad/s = 1000.0;
        der(x) = v;
        der(v) = -powi(omega, 2) * x;
    }
}

model! {
    /// What grows out of almost nothing: runs away, or swings ever more.
    pub struct Growing {
        state x = 1e-12;
        state v = 0.0;
        param pull = 1.0;
        param push = 0.0;
        der(x) = v;
        der(v) = push * v + pull * x;
    }
}

fn case(system: &System) -> Case {
    Case::declared(system.info(), Dynamics::Exact)
}

#[test]
fn nanometres_have_as_many_digits_as_metres() {
    let system = System::of::<Tiny, _>();
    let motion = system.motion(&case(&system), 0.01).unwrap();
    let end = motion.states.last().unwrap();
    let right = [5e-9 * 10.0_f64.cos(), -5e-6 * 10.0_f64.sin()];
    for (j, size) in [5e-9, 5e-6].into_iter().enumerate() {
        assert!((end[j] - right[j]).abs() < 1e-8 * size, "{end:?}");
        assert!((motion.max[j] / size - 1.0).abs() < 1e-8, "{motion:?}");
        assert!((motion.min[j] / size + 1.0).abs() < 1e-8, "{motion:?}");
    }
}

#[test]
fn they_cross_a_section_when_they_do() {
    let system = System::of::<Tiny, _>();
    let section = Section {
        surface: Surface::Level {
            state: 0,
            value: 0.0,
        },
        direction: Direction::Up,
    };
    let met = system.crossings(&case(&system), section, Span::Time(0.01));
    let times: Vec<f64> = met.unwrap().points.iter().map(|one| one.time).collect();
    let [time] = times[..] else {
        panic!("{times:?}");
    };
    let right = 1.5e-3 * std::f64::consts::PI;
    assert!((time / right - 1.0).abs() < 1e-8, "{time} for {right}");
}

#[test]
fn what_grows_is_measured_against_what_it_becomes() {
    let system = System::of::<Growing, _>();
    for time in [10.0, 60.0] {
        let motion = system.motion(&case(&system), time).unwrap();
        let (end, right) = (motion.states.last().unwrap(), 1e-12 * f64::cosh(time));
        assert!((end[0] / right - 1.0).abs() < 1e-7, "{end:?} for {right}");
    }
}

#[test]
fn what_swings_is_too() {
    let system = System::of::<Growing, _>();
    let mut case = case(&system);
    case.parameters = vec![-1.0, 0.1];
    let (rate, turn) = (0.05, (1.0_f64 - 0.05 * 0.05).sqrt());
    for time in [200.0, 600.0] {
        let motion = system.motion(&case, time).unwrap();
        let (sin, cos) = (turn * time).sin_cos();
        let size = 1e-12 * (rate * time).exp();
        let right = size * (cos - rate / turn * sin);
        let end = motion.states.last().unwrap();
        assert!((end[0] - right).abs() < 1e-6 * size, "{end:?} for {right}");
    }
}

model! {
    /// A hung mass that is shaken ever less: swings far smaller than where it hangs.
    pub struct Hung {
        state x: m = 1.0;
        state v: m/s = 0.0;
        param k: 1/s^2 = 9.81;
        param c: 1/s = 0.5;
        param load: m/s^2 = 1.0;
        param omega: rad/s = 2.0 where omega > 0.0;
        drive phi at omega;
        der(x) = v;
        der(v) = 9.81 - k * x - c * v + load * cos(phi);
    }
}

/// Its response is linear: nothing happens where the load changes its sign.
#[test]
fn a_branch_passes_through_where_nothing_swings() {
    let system = System::of::<Hung, _>();
    let mut case = case(&system);
    let (design, from, to) = (Design::Parameter(Hung::load.index), 1.0, -0.5);
    case.along = Some(Along { design, from, to });
    let branch = system.branch(&case.at(from)).unwrap();
    assert!(branch.ended.is_whole(), "{}", branch.ended.reason);
    let last = branch.points.last().unwrap();
    let swing = 0.5 / (9.81_f64 - 4.0).hypot(1.0);
    assert!((last.max[0] - 1.0 - swing).abs() < 1e-8, "{last:?}");
}
