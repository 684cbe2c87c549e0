//! Orbits but for a shift: angles that turn, bodies that crawl.

use stickslip::continuation::{Ending, Kind};
use stickslip::field::Design;
use stickslip::model;
use stickslip::study::{
    Along, Case, Diagram, Dynamics, Motion, OrbitRecord, Section, StudyError, Sweep, System,
};
use stickslip_models::friction::{Coulomb, Jenkins};
use stickslip_models::press::{Compliant, Rigid};

model! {
    /// A pendulum under a torque, with a bearing that rubs.
    pub struct Turned {
        state x: rad = 0.0;
        state v: rad/s = 5.0;
        param alpha: 1/s = 0.1;
        param weight: 1/s^2 = 1.0;
        param torque: 1/s^2 = 0.5;
        param dry: 1/s^2 = 0.1 where dry >= 0.0;
        friction F: 1/s^2 = Coulomb { level: dry } opposing v;
        der(x) = v;
        der(v) = torque + F - alpha * v - weight * sin(x);
    }
}

model! {
    /// A capsule that is shaken from within and crawls: where both masses are.
    pub struct Capsule {
        state x: m = 0.0;
        state y: m = 0.0;
        state vx: m/s = 0.0;
        state vy: m/s = 0.0;
        param inner: kg = 1.0 where inner > 0.0;
        param outer: kg = 2.0 where outer > 0.0;
        param k: N/m = 100.0;
        param c: N*s/m = 1.0;
        param wall: N/m = 2000.0 where wall > 0.0;
        param gap: m = 0.01;
        param load: N = 8.0;
        param omega: rad/s = 10.0 where omega > 0.0;
        param level: N = 3.0 where level >= 0.0;
        drive phi at omega;
        press N: N = Compliant { stiffness: wall, damping: 0.0 } closing gap - (x - y);
        friction F: N = Coulomb { level: level } opposing vy;
        der(x) = vx;
        der(y) = vy;
        der(vx) = (load * cos(phi) - k * (x - y) - c * (vx - vy) - N) / inner;
        der(vy) = (F + k * (x - y) + c * (vx - vy) + N) / outer;
    }
}

model! {
    /// The same capsule: how far the inner mass is from the outer one.
    pub struct Within {
        state d: m = 0.0;
        state vx: m/s = 0.0;
        state vy: m/s = 0.0;
        param inner: kg = 1.0 where inner > 0.0;
        param outer: kg = 2.0 where outer > 0.0;
        param k: N/m = 100.0;
        param c: N*s/m = 1.0;
        param wall: N/m = 2000.0 where wall > 0.0;
        param gap: m = 0.01;
        param load: N = 8.0;
        param omega: rad/s = 10.0 where omega > 0.0;
        param level: N = 3.0 where level >= 0.0;
        drive phi at omega;
        press N: N = Compliant { stiffness: wall, damping: 0.0 } closing gap - d;
        friction F: N = Coulomb { level: level } opposing vy;
        der(d) = vx - vy;
        der(vx) = (load * cos(phi) - k * d - c * (vx - vy) - N) / inner;
        der(vy) = (F + k * d + c * (vx - vy) + N) / outer;
    }
}

model! {
    /// A crank with a slider on its guide, which need not rub.
    pub struct Crank {
        state phi: rad = 0.3;
        state w: rad/s = 2.0;
        param torque: 1/s^2 = 1.0;
        param damp: 1/s = 0.5;
        param rough: 1/s^2 = 0.0 where rough >= 0.0;
        friction F: 1/s^2 = Coulomb { level: rough } opposing sin(phi) * w;
        der(phi) = w;
        der(w) = torque - damp * w + F * sin(phi);
    }
}

model! {
    /// A part on a trough that shakes along a slanted line: beyond throw g it would hop.
    pub struct Conveyor {
        state x: m = 0.0;
        state y: m = 0.0;
        state vx: m/s = 0.0;
        state vy: m/s = 0.0;
        param throw: m = 0.4 where throw > 0.0;
        param cot: 1 = 1.7;
        param mu: 1 = 0.4 where mu >= 0.0;
        param g: m/s^2 = 1.0;
        param omega: rad/s = 1.0 where omega > 0.0;
        drive phi at omega;
        press N: m/s^2 = Rigid { restitution: 0.1 } closing y - throw * sin(phi);
        friction F: m/s^2 = Coulomb { level: mu * N } opposing vx - throw * omega * cot * cos(phi);
        der(x) = vx;
        der(y) = vy;
        der(vx) = F;
        der(vy) = N - g;
    }
}

fn along(system: &System, parameter: usize, from: f64, to: f64) -> Case {
    let design = Design::Parameter(parameter);
    Case {
        along: Some(Along { design, from, to }),
        ..Case::declared(system.info(), Dynamics::Exact).at(from)
    }
}

fn close(found: f64, right: f64, accuracy: f64) {
    let off = (found - right).abs();
    assert!(
        off <= accuracy * right.abs().max(1.0),
        "{found} for {right}"
    );
}

/// Over a turn areas shrink by exp(−α T), and the torque works as much as the damping: 2π (M − dry) = α ∫ v² dt.
fn turns_as_it_should(orbit: &OrbitRecord, torque: f64) {
    let gain = orbit.shift.as_ref().unwrap();
    assert_eq!(*gain, [std::f64::consts::TAU, 0.0]);
    let one = orbit.floquet.multipliers[0];
    close(one.re, (-0.1 * orbit.period).exp(), 1e-8);
    // ∫ v² dt is least, (2π)²/T, at a constant speed.
    let mean = std::f64::consts::TAU / orbit.period;
    assert!(mean < (torque - 0.1) / 0.1 && mean > orbit.min[1], "{mean}");
}

#[test]
fn a_pendulum_turns_until_it_stops_at_the_top() {
    let system = System::of::<Turned, _>();
    let case = Case::declared(system.info(), Dynamics::Exact);
    let case = Case {
        start: Some(vec![0.0, 5.0]),
        ..case
    };
    turns_as_it_should(&system.orbit(&case).unwrap(), 0.5);
    let case = Case {
        start: Some(vec![0.0, 5.0]),
        ..along(&system, Turned::torque.index, 0.5, 0.1)
    };
    let branch = system.branch(&case).unwrap();
    for orbit in branch.points.iter().filter(|orbit| orbit.period < 10.0) {
        turns_as_it_should(orbit, orbit.r.unwrap());
    }
    // Its period grows without bound where it meets the saddle, by Melnikov's integral at M − dry = 4 α/π + O(α²).
    let Ending::Homoclinic(torque) = branch.ended.ending else {
        panic!("{}", branch.ended.reason);
    };
    for torque in [torque, branch.points.last().unwrap().r.unwrap()] {
        assert!((torque - 0.1 - 0.4 / std::f64::consts::PI).abs() < 1e-2);
    }
}

/// Where nothing rubs it turns at 2 rad/s for ever, and any time would be a period.
#[test]
fn what_turns_steadily_is_no_orbit() {
    let system = System::of::<Crank, _>();
    let case = Case::declared(system.info(), Dynamics::Exact);
    for period in [None, Some(1e-9), Some(0.3)] {
        let case = Case {
            start: Some(vec![0.3, 2.0]),
            period,
            ..case.clone()
        };
        let error = system.orbit(&case).unwrap_err();
        assert!(matches!(error, StudyError::Orbit(_)), "{error}");
    }
}

#[test]
fn a_capsule_crawls_as_it_does_in_its_own_frame() {
    let [whole, within] = [System::of::<Capsule, _>(), System::of::<Within, _>()];
    let omega = [Capsule::omega.index, Within::omega.index];
    let branch = |system: &System, omega| system.branch(&along(system, omega, 10.0, 14.0)).unwrap();
    let (whole, within) = (branch(&whole, omega[0]), branch(&within, omega[1]));
    assert!(whole.special.len() > 2 && whole.special.len() == within.special.len());
    for (a, b) in whole.special.iter().zip(&within.special) {
        assert_eq!(a.kind, b.kind);
        close(a.r, b.r, 1e-9);
    }
    let (first, inner) = (&whole.points[0], &within.points[0]);
    assert_eq!(first.word, inner.word);
    for (a, b) in first
        .floquet
        .multipliers
        .iter()
        .zip(&inner.floquet.multipliers)
    {
        close((a - b).norm(), 0.0, 1e-8);
    }
    // Impulses over a period: friction's mean is nothing, and both masses get on by the same.
    let gain = first.shift.as_ref().unwrap();
    close(gain[0], gain[1], 1e-12);
    assert!(gain[0] > 0.06 && first.held.len() == 1, "{gain:?}");
}

#[test]
fn a_period_that_is_given_leads_to_the_same_motion() {
    let system = System::of::<Turned, _>();
    let case = Case {
        start: Some(vec![3.1, 3.7]),
        period: Some(1.57),
        ..Case::declared(system.info(), Dynamics::Exact)
    };
    turns_as_it_should(&system.orbit(&case).unwrap(), 0.5);
}

model! {
    /// A pile that a vibrator drives into soil: forces of tens of kilonewtons beside millimetres.
    pub struct Pile {
        state y: m = 0.0;
        state v: m/s = 0.0;
        state z: N = 0.0;
        param m: kg = 2000.0 where m > 0.0;
        param weight: N = 30e3;
        param load: N = 300e3;
        param omega: rad/s = 160.0 where omega > 0.0;
        param ks: N/m = 1.2e8 where ks > 0.0;
        param level: N = 150e3 where level > 0.0;
        param c: N*s/m = 2e4;
        drive phi at omega;
        friction F: N = Jenkins { stiffness: ks, level: level } opposing v with z;
        der(y) = v;
        der(v) = (F + weight + load * cos(phi) - c * v) / m;
    }
}

/// Nothing depends on how deep it is, everything on the force in the soil, by however little beside its own rate. What it
/// loses of momentum it gains: the mean of all forces is none.
#[test]
fn a_pile_sinks_by_the_same_way_each_time() {
    let system = System::of::<Pile, _>();
    let case = Case::declared(system.info(), Dynamics::Exact);
    let orbit = system.orbit(&case).unwrap();
    let gain = orbit.shift.as_ref().unwrap();
    assert_eq!(gain[1..], [0.0; 3], "only the depth grows");
    let start = Some(orbit.state.clone());
    let motion = system.motion(&Case { start, ..case }, orbit.period);
    let end = motion.unwrap().states.last().cloned().unwrap();
    close((end[0] - orbit.state[0]) / gain[0], 1.0, 1e-8);
    assert!(gain[0] > 0.009 && gain[0] < 0.01, "{gain:?}");
}

model! {
    /// A clutch whose disc is out of true: it is pressed more in one half of each turn of the one side against the other.
    pub struct Untrue {
        state lag: rad = 0.0;
        state w: rad/s = 0.0;
        state twist: rad = 0.0;
        param engine: rad/s = 30.0;
        param uneven = 0.1 where 0.0 <= uneven < 1.0;
        friction T: N*m = Coulomb { level: 30.0 * (1.0 + uneven * cos(lag)) } opposing w - engine;
        der(lag) = engine - w;
        der(w) = (T - 200.0 * twist - 0.2 * w) / 0.02;
        der(twist) = w;
    }
}

/// The twist comes back, so that the disc gets on by nothing, and the engine turns against it once in 2π/30 s. Half a turn is
/// gained in half of that, and changes where it is pressed.
#[test]
fn half_a_turn_is_no_period() {
    let system = System::of::<Untrue, _>();
    let turn = std::f64::consts::TAU / 30.0;
    let case = Case {
        start: Some(vec![1.607, -0.472, 0.14]),
        ..along(&system, Untrue::uneven.index, 0.1, 0.9)
    };
    let orbit = system.orbit(&case).unwrap();
    let given = Case {
        start: Some(orbit.state.clone()),
        period: Some(turn),
        ..case.clone()
    };
    for orbit in [orbit, system.orbit(&given).unwrap()] {
        close(orbit.period, turn, 1e-9);
    }
    let branch = system.branch(&case).unwrap();
    assert!(branch.ended.is_whole(), "{}", branch.ended.reason);
    for orbit in &branch.points {
        close(orbit.period, turn, 1e-9);
    }
}

model! {
    /// A mole: a hammer within hits its shell, which rubs in the soil and gets on.
    pub struct Mole {
        state d = 0.0;
        state vh = 0.0;
        state vt = 0.0;
        state deep = 0.0;
        param restitution = 0.4;
        param omega = 20.0 where omega > 0.0;
        drive phi at omega;
        press N = Rigid { restitution: restitution } closing 0.01 - d;
        friction S = Coulomb { level: 15.0 } opposing vt;
        der(d) = vh - vt;
        der(vh) = 12.0 * cos(phi) - 400.0 * d - (vh - vt) - N;
        der(vt) = (S + 2.0 + 400.0 * d + vh - vt + N - 12.0 * cos(phi)) / 3.0;
        der(deep) = vt;
    }
}

/// Where the second of its impacts vanishes, it hits a shell that sticks, and knocks it loose for as long as its speed lasts.
#[test]
fn an_impact_that_vanishes_knocks_loose_what_sticks() {
    let system = System::of::<Mole, _>();
    let found = system
        .branch(&along(&system, Mole::restitution.index, 0.4, 1.0))
        .unwrap();
    let kinds: Vec<Kind> = found.special.iter().map(|one| one.kind).collect();
    let wanted = [
        Kind::Fold,
        Kind::GrazingSliding,
        Kind::Grazing,
        Kind::AddingSliding,
    ];
    assert_eq!(kinds[..4], wanted);
    assert_eq!(found.ended.word(), "reached-end");
    let hits = |orbit: &OrbitRecord| orbit.word.as_ref().unwrap().matches("impact").count();
    let [first, last] = [&found.points[0], found.points.last().unwrap()];
    assert_eq!([hits(first), hits(last)], [2, 1]);
    // Another motion leads to the same orbit.
    let alone = system
        .orbit(&along(&system, Mole::restitution.index, 1.0, 1.0))
        .unwrap();
    assert_eq!(hits(&alone), 1);
    close(alone.max[1], last.max[1], 1e-8);
    close(
        alone.shift.as_ref().unwrap()[3],
        last.shift.as_ref().unwrap()[3],
        1e-8,
    );
}

/// Where it rests on its stop as a value ends, the next cannot begin beside that: a wall is there.
#[test]
fn what_gets_on_is_periodic_in_a_diagram() {
    let system = System::of::<Mole, _>();
    let diagram = Diagram {
        section: Section::default(),
        sweep: Sweep::Up,
        values: 3,
        settle: 100,
        points: 32,
        lyapunov: None,
    };
    let case = along(&system, Mole::omega.index, 10.0, 40.0);
    let record = system.diagram(&case, &diagram).unwrap();
    for slice in &record.sweeps[0].slices {
        assert_eq!(slice.motion, Motion::Periodic(1), "{}", slice.r);
    }
}

/// Wherever shooting begins, which moves along a branch, a lap is told from where its section is met, and held there alike.
#[test]
fn extents_of_what_runs_on_do_not_depend_on_how_its_branch_was_followed() {
    let system = System::of::<Conveyor, _>();
    for (from, to) in [(0.405, 0.43), (0.43, 0.405)] {
        let case = along(&system, Conveyor::throw.index, from, to);
        let branch = system.branch(&case).unwrap();
        assert!(branch.ended.is_whole(), "{}", branch.ended.reason);
        for orbit in &branch.points {
            let alone = Case {
                along: None,
                ..case.at(orbit.r.unwrap())
            };
            let alone = system.orbit(&alone).unwrap();
            close(orbit.held[0].value, 0.0, 1e-12);
            for (found, right) in orbit.max.iter().zip(&alone.max) {
                close(*found, *right, 1e-8);
            }
            for (found, right) in orbit.section[0].iter().zip(&alone.section[0]) {
                close(*found, *right, 1e-8);
            }
        }
    }
}
