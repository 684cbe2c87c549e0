//! Borders of orbits whose halves mirror each other: what vanishes in one half vanishes in the other.

use stickslip::continuation::Kind;
use stickslip::field::Design;
use stickslip::model;
use stickslip::study::{Along, Case, Dynamics, System};
use stickslip_models::friction::{Coulomb, CoulombStatic};
use stickslip_models::press::Compliant;

model! {
    /// The joint of a robot: a motor, a gear with play and an arm that hangs, after Tjahjowidodo, Al-Bender and Van Brussel.
    pub struct Joint {
        state motor: rad = 0.0;
        state w: rad/s = 0.0;
        state arm: rad = 0.0;
        state u: rad/s = 0.0;
        param play: rad = 0.01 where play > 0.0;
        param stiffness: N*m/rad = 1500.0 where stiffness > 0.0;
        param weight: N*m = 10.0;
        param torque: N*m = 9.0;
        param rough: N*m = 1.5 where rough >= 0.0;
        param inertia: kg*m^2 = 0.12 where inertia > 0.0;
        param heavy: kg*m^2 = 0.4 where heavy > 0.0;
        drive phi at 6.0;
        press D: N*m = Compliant { stiffness: stiffness, damping: 2.0 } closing play + arm - motor;
        press B: N*m = Compliant { stiffness: stiffness, damping: 2.0 } closing play - arm + motor;
        friction F: N*m = CoulombStatic { static_level: 1.2 * rough, kinetic_level: rough } opposing w;
        friction G: N*m = Coulomb { level: 0.4 } opposing u;
        der(motor) = w;
        der(arm) = u;
        der(w) = (torque * cos(phi) + F - D + B - 0.2 * w) / inertia;
        der(u) = (D - B + G - weight * sin(arm)) / heavy;
    }
}

/// Both halves of the orbit lose a stick at one torque. Motions that settle beside it tell where: before it they have both, and
/// beyond they repeat otherwise. An orbit that lacks one of them meets the border of the other elsewhere.
#[test]
fn both_halves_lose_their_stick_where_no_orbit_has_it_any_more() {
    let system = System::of::<Joint, _>();
    let design = Design::Parameter(Joint::torque.index);
    let at = |torque: f64| Case {
        along: Some(Along {
            design,
            from: torque,
            to: 4.0,
        }),
        ..Case::declared(system.info(), Dynamics::Exact).at(torque)
    };
    let branch = system.branch(&at(3.166)).unwrap();
    let last = branch.special.last().unwrap();
    assert_eq!(last.kind, Kind::GrazingSliding);
    let sticks = |torque: f64| {
        let orbit = system.orbit(&at(torque)).unwrap();
        orbit.word.unwrap().matches("stick").count()
    };
    assert_eq!(sticks(last.r * (1.0 - 1e-6)), 4);
    assert_ne!(sticks(last.r * (1.0 + 1e-6)), 4);
}
