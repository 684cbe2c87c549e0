//! Contacts that friction holds all along: where they could be held as well, and how branches come to that and go on.

use stickslip::bifurcation::Stability;
use stickslip::field::Design;
use stickslip::model;
use stickslip::study::{Along, BranchRecord, Case, Dynamics, OrbitRecord, System};
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Compliant;

model! {
    /// A taut cable in two modes, with a damper near its end that rubs.
    pub struct Cable {
        state q[2] = 0.0;
        state p[2] = 0.0;
        param dry = 1.0 where dry >= 0.0;
        param zeta = 0.002 where zeta >= 0.0;
        param load = 0.02;
        param omega = 0.5 where omega > 0.0;
        drive phi at omega;
        friction F = Coulomb { level: dry } opposing 0.156 * p[0] + 0.309 * p[1];
        der(q[0]) = p[0];
        der(q[1]) = p[1];
        der(p[0]) = -q[0] - 2.0 * zeta * p[0] + 0.156 * F + 0.95 * load * cos(phi);
        der(p[1]) = -4.0 * q[1] - 4.0 * zeta * p[1] + 0.309 * F + 0.588 * load * cos(phi);
    }
}

model! {
    /// A building with a small mass on a spring that rubs.
    pub struct Absorber {
        state x = 0.0;
        state y = 0.0;
        state v = 0.0;
        state u = 0.0;
        param zeta = 0.01 where zeta >= 0.0;
        param mass = 0.05 where mass > 0.0;
        param tune = 0.95 where tune > 0.0;
        param dry = 0.02 where dry >= 0.0;
        param load = 0.05;
        param omega = 1.0 where omega > 0.0;
        drive phi at omega;
        friction F = Coulomb { level: dry } opposing u - v;
        let spring = mass * tune * tune * (y - x);
        der(x) = v;
        der(y) = u;
        der(v) = load * cos(phi) - x - 2.0 * zeta * v + spring - F;
        der(u) = (F - spring) / mass;
    }
}

model! {
    /// A quarter of a car on a leaf spring that rubs, on a tyre that a wavy road may leave.
    pub struct QuarterCar {
        state zs: m = 0.0;
        state zu: m = 0.0;
        state vs: m/s = 0.0;
        state vu: m/s = 0.0;
        param ms: kg = 300.0 where ms > 0.0;
        param mu: kg = 40.0 where mu > 0.0;
        param ks: N/m = 2.0e4 where ks > 0.0;
        param kt: N/m = 1.8e5 where kt > 0.0;
        param ct: N*s/m = 200.0 where ct >= 0.0;
        param dry: N = 300.0 where dry >= 0.0;
        param road: m = 0.005;
        param omega: rad/s = 10.0 where omega > 0.0;
        param g: m/s^2 = 9.81;
        drive phi at omega;
        press T: N = Compliant { stiffness: kt, damping: ct } closing zu - road * sin(phi) - (ms + mu) * g / kt;
        friction F: N = Coulomb { level: dry } opposing vs - vu;
        let leaf = ks * (zs - zu);
        der(zs) = vs;
        der(zu) = vu;
        der(vs) = (F - leaf) / ms;
        der(vu) = (leaf - F + T - (ms + mu) * g) / mu;
    }
}

fn branch(system: &System, parameter: usize, [from, to]: [f64; 2]) -> BranchRecord {
    let design = Design::Parameter(parameter);
    let case = Case {
        along: Some(Along { design, from, to }),
        ..Case::declared(system.info(), Dynamics::Exact)
    };
    let branch = system.branch(&case).expect("a branch");
    assert!(branch.ended.is_whole(), "{}", branch.ended.reason);
    branch
}

/// The same both ways, special points included.
fn both_ways(
    system: &System,
    parameter: usize,
    [from, to]: [f64; 2],
    accuracy: f64,
) -> BranchRecord {
    let there = branch(system, parameter, [from, to]);
    let back = branch(system, parameter, [to, from]);
    assert_eq!(there.special.len(), back.special.len());
    for (a, b) in there.special.iter().zip(back.special.iter().rev()) {
        assert!((a.r / b.r - 1.0).abs() <= accuracy, "{} {}", a.r, b.r);
    }
    there
}

/// The amplitude of the first mode while the damper holds: a single mass swings, across the shape at the damper.
fn held_amplitude(omega: f64) -> f64 {
    let (a, b) = (0.156_f64, 0.309_f64);
    let square = a * a + b * b;
    let stiffness = (b * b + 4.0 * a * a) / square;
    let damping = 0.004 * (b * b + 2.0 * a * a) / square;
    let load = 0.02 * (0.95 * b - 0.588 * a) / square;
    b * load / (stiffness - omega * omega).hypot(damping * omega)
}

/// The force of the damper is greatest at the very moment at which the orbit begins.
#[test]
fn what_friction_holds_is_followed_through_resonance_both_ways() {
    let system = System::of::<Cable, _>();
    let branch = both_ways(&system, Cable::omega.index, [0.4, 3.0], 1e-6);
    assert_eq!(branch.special.len(), 2);
    let held = |orbit: &&OrbitRecord| orbit.word.as_deref() == Some("stick(F)");
    let mut count = 0;
    for orbit in branch.points.iter().filter(held) {
        let right = held_amplitude(orbit.r.expect("a value"));
        assert!((orbit.max[0] / right - 1.0).abs() < 1e-8, "{:?}", orbit.r);
        assert!(orbit.held[0].value.abs() < 1e-11, "{:?}", orbit.held);
        count += 1;
    }
    assert!(count > 50, "{count}");
}

/// Newton's method reaches the orbit from its calmest place, and what is neutral about it has been found before that.
#[test]
fn what_is_neutral_is_held_wherever_shooting_begins() {
    let system = System::of::<Absorber, _>();
    let mut case = Case::declared(system.info(), Dynamics::Exact);
    case.parameters[Absorber::zeta.index] = 0.1;
    let orbit = system.orbit(&case).expect("an orbit");
    assert_eq!(orbit.held.len(), 1, "{:?}", orbit.held);
    assert_eq!(orbit.floquet.stability, Stability::Stable);
    assert!(orbit.error_estimate < 1e-10, "{}", orbit.error_estimate);
    branch(&system, Absorber::zeta.index, [0.1, 0.001]);
}

#[test]
fn a_branch_goes_on_where_friction_begins_to_hold() {
    let system = System::of::<QuarterCar, _>();
    let branch = both_ways(&system, QuarterCar::ms.index, [600.0, 100.0], 1e-6);
    assert_eq!(branch.special.len(), 4);
}
