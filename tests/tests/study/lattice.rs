//! Motions that run on over what repeats after a length of its own.

use std::f64::consts::TAU;

use stickslip::field::Design;
use stickslip::model;
use stickslip::study::{Along, Case, Dynamics, OrbitRecord, System};
use stickslip_models::friction::Coulomb;

model! {
    /// A tip over a row of atoms that is steeper to one side, rocked to and fro, in nanometres.
    pub struct Rocked {
        state x = 0.03;
        state v = 0.0;
        param a = 0.3 where a > 0.0;
        param b = 0.1;
        param rock = 0.12;
        param dry = 0.01 where dry >= 0.0;
        param omega = 0.67 where omega > 0.0;
        drive phi at omega;
        let pi = std::f64::consts::PI;
        let y = 2.0 * pi * x / a;
        friction F = Coulomb { level: a * dry } opposing v;
        der(x) = v;
        der(v) = F - b * v + a * (rock * cos(phi) - (cos(y) + 0.5 * cos(2.0 * y)) / (2.0 * pi));
    }
}

model! {
    /// The same: which angle of its cell it has come to.
    pub struct Angle {
        state y = 0.628;
        state u = 0.0;
        param b = 0.1;
        param rock = 0.12;
        param dry = 0.01 where dry >= 0.0;
        param omega = 0.67 where omega > 0.0;
        drive phi at omega;
        let pi = std::f64::consts::PI;
        friction F = Coulomb { level: 2.0 * pi * dry } opposing u;
        der(y) = u;
        der(u) = F - b * u + 2.0 * pi * rock * cos(phi) - cos(y) - 0.5 * cos(2.0 * y);
    }
}

model! {
    /// A motor that rubs, a shaft that gives way, and an eccentric load.
    pub struct Shaft {
        state q = 0.0;
        state y = 0.0;
        state w = 5.0;
        state u = 5.0;
        param torque = 1.2;
        param k = 30.0 where k > 0.0;
        param dry = 0.2 where dry >= 0.0;
        friction F: N*m = Coulomb { level: dry } opposing w;
        der(q) = w;
        der(y) = u;
        der(w) = (torque + F - 0.1 * w - k * (q - y)) / 0.5;
        der(u) = k * (q - y) - 0.1 * u - sin(y);
    }
}

model! {
    /// The same: by how much the shaft is twisted.
    pub struct Twist {
        state twist = 0.0;
        state y = 0.0;
        state w = 5.0;
        state u = 5.0;
        param torque = 1.2;
        param k = 30.0 where k > 0.0;
        param dry = 0.2 where dry >= 0.0;
        friction F: N*m = Coulomb { level: dry } opposing w;
        der(twist) = w - u;
        der(y) = u;
        der(w) = (torque + F - 0.1 * w - k * twist) / 0.5;
        der(u) = k * twist - 0.1 * u - sin(y);
    }
}

/// Angles of which rates hear the difference turn together.
#[test]
fn both_ends_of_a_shaft_turn_together() {
    let [ends, twist] = [System::of::<Shaft, _>(), System::of::<Twist, _>()].map(|s| orbit(&s));
    let gain = ends.shift.as_ref().unwrap();
    assert!(
        (gain[0] - TAU).abs() < 1e-11 && (gain[1] - TAU).abs() < 1e-11,
        "{gain:?}"
    );
    assert_eq!(gain[2..], [0.0; 2]);
    assert!((ends.period / twist.period - 1.0).abs() < 1e-8);
    let [one, other] = [&ends, &twist].map(|one| one.floquet.multipliers[0]);
    assert!((one - other).norm() < 1e-7, "{one} {other}");
}

fn orbit(system: &System) -> OrbitRecord {
    let case = Case::declared(system.info(), Dynamics::Exact);
    system.orbit(&case).unwrap()
}

/// It gets on by one atom in each turn of the drive, whatever it is measured in.
#[test]
fn a_tip_gets_on_by_an_atom() {
    let [tip, angle] = [System::of::<Rocked, _>(), System::of::<Angle, _>()].map(|s| orbit(&s));
    let [tip_gain, angle_gain] = [&tip, &angle].map(|one| one.shift.as_ref().unwrap()[0]);
    assert!((tip_gain + 0.3).abs() < 1e-12, "{tip_gain}");
    assert!((angle_gain + TAU).abs() < 1e-12, "{angle_gain}");
    assert!((tip.period - TAU / 0.67).abs() < 1e-9);
    let [one, other] = [&tip, &angle].map(|one| one.floquet.multipliers[0]);
    assert!((one - other).norm() < 1e-7, "{one} {other}");
}

/// Where the atoms move apart it gets on by another way: that is told, with the state that would not.
#[test]
fn a_length_that_changes_is_told() {
    let system = System::of::<Rocked, _>();
    let branch = |parameter: usize, from: f64, to: f64| {
        let design = Design::Parameter(parameter);
        let case = Case {
            along: Some(Along { design, from, to }),
            ..Case::declared(system.info(), Dynamics::Exact).at(from)
        };
        system.branch(&case).unwrap()
    };
    let ended = branch(Rocked::a.index, 0.3, 0.4).ended;
    assert!(ended.reason.contains("as in x/a"), "{}", ended.reason);
    let ended = branch(Rocked::b.index, 0.1, 0.11).ended;
    assert!(ended.is_whole(), "{}", ended.reason);
}
