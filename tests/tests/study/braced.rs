//! Contacts that hold two states between them, neither by itself.

use stickslip::field::Design;
use stickslip::model;
use stickslip::model::Model as _;
use stickslip::study::{Along, Case, Dynamics, System};
use stickslip_models::friction::Coulomb;

model! {
    /// The drum of a washing machine on two slanted struts that rub.
    pub struct Washer {
        state x: m = 0.0;
        state vx: m/s = 0.0;
        state y: m = 0.0;
        state vy: m/s = 0.0;
        param mass: kg = 40.0 where mass > 0.0;
        param kx: N/m = 6000.0;
        param ky: N/m = 9000.0;
        param unbalance: kg*m = 0.1;
        param dry: N = 60.0 where dry >= 0.0;
        param slant: rad = 0.5;
        param omega: rad/s = 12.0 where omega > 0.0;
        drive phi at omega;
        friction L: N = Coulomb { level: dry } opposing vx * sin(slant) + vy * cos(slant);
        friction R: N = Coulomb { level: dry } opposing vy * cos(slant) - vx * sin(slant);
        der(x) = vx;
        der(vx) = ((L - R) * sin(slant) - kx * x + unbalance * omega * omega * cos(phi)) / mass;
        der(y) = vy;
        der(vy) = ((L + R) * cos(slant) - ky * y + unbalance * omega * omega * sin(phi)) / mass;
    }
}

/// Held in the middle, each strut bears e ω²/sin 2α; rounding errors of what they share moved the drum, by which its motion was
/// measured.
#[test]
fn what_contacts_hold_together_stays_where_it_is() {
    let system = System::of::<Washer, _>();
    let case = Case::declared(Washer::INFO, Dynamics::Exact);
    let held = system.orbit(&case).unwrap();
    assert!(held.max_abs[..4].iter().all(|y| *y == 0.0), "{held:?}");

    let mut case = case;
    case.along = Some(Along {
        design: Design::Parameter(Washer::dry.index),
        from: 15.0,
        to: 60.0,
    });
    let branch = system.branch(&case.at(15.0)).unwrap();
    assert!(branch.ended.is_whole(), "{}", branch.ended.reason);
    let lets_go = branch.special.last().unwrap();
    let right = 14.4 / 1.0_f64.sin();
    assert!((lets_go.r - right).abs() < 1e-5 * right, "{lets_go:?}");
    assert!((lets_go.r - right).abs() < lets_go.error.unwrap());
}
