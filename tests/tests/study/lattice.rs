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
        state y = 0.2 * std::f64::consts::PI;
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
