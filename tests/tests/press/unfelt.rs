//! Walls are not felt before they are hit: between them no rate depends on where a body is.

use std::f64::consts::TAU;

use stickslip::model;
use stickslip::study::{Case, Dynamics, OrbitRecord, System};
use stickslip_models::friction::Coulomb;
use stickslip_models::press::{Compliant, Rigid};

model! {
    /// A verge escapement: the three teeth of a wheel under torque beat a foliot to and fro.
    struct Verge {
        state foliot: rad = 0.1;
        state wheel: rad = 0.0;
        state w: rad/s = 1.0;
        state u: rad/s = 1.0;
        param J: kg*m^2 = 1.0 where J > 0.0;
        param torque: N*m = 0.2;
        param drag: N*m*s = 0.05;
        param e = 0.1 where 0.0 <= e <= 1.0;
        press P: N*m = Rigid { restitution: e } closing 0.4 + foliot - 0.6 * sin(3.0 * wheel);
        press Q: N*m = Rigid { restitution: e } closing 0.4 - foliot + 0.6 * sin(3.0 * wheel);
        friction M: N*m = Coulomb { level: 0.01 } opposing w;
        der(foliot) = w;
        der(wheel) = u;
        der(w) = (M + P - Q) / J;
        der(u) = 20.0 * (torque - drag * u - 1.8 * cos(3.0 * wheel) * (P - Q)) / J;
    }
}

model! {
    /// A hammer that drives a bit which dry friction holds, after Pavlovskaia and Wiercigroch: where both are.
    struct Placed {
        state x = 0.0;
        state y = 0.02;
        state v = 0.0;
        state u = 0.0;
        param omega = 0.1 where omega > 0.0;
        drive phi at omega;
        press N = Compliant { stiffness: 1.0, damping: 0.1 } closing y - x;
        friction F = Coulomb { level: 1.0 } opposing u;
        der(x) = v;
        der(y) = u;
        der(v) = 0.15 + 0.3 * cos(phi) - N;
        der(u) = (F + N) / 0.1;
    }
}

model! {
    /// The same: how far the bit is before the hammer.
    struct Ahead {
        state d = 0.02;
        state v = 0.0;
        state u = 0.0;
        param omega = 0.1 where omega > 0.0;
        drive phi at omega;
        press N = Compliant { stiffness: 1.0, damping: 0.1 } closing d;
        friction F = Coulomb { level: 1.0 } opposing u;
        der(d) = u - v;
        der(v) = 0.15 + 0.3 * cos(phi) - N;
        der(u) = (F + N) / 0.1;
    }
}

fn orbit(system: &System) -> OrbitRecord {
    let case = Case::declared(system.info(), Dynamics::Exact);
    system.orbit(&case).unwrap()
}

/// A part of a turn that is no tooth leads behind a pallet, which was told to whoever began where it is open.
#[test]
fn an_escapement_gets_on_by_a_tooth() {
    let gain = orbit(&System::of::<Verge, _>()).shift.unwrap();
    assert!((gain[1] - TAU / 3.0).abs() < 1e-8, "{gain:?}");
    assert_eq!([gain[0], gain[2], gain[3]], [0.0; 3]);
}

#[test]
fn what_is_driven_ahead_gets_on_with_the_hammer() {
    let [placed, ahead] = [System::of::<Placed, _>(), System::of::<Ahead, _>()].map(|s| orbit(&s));
    let gain = placed.shift.unwrap();
    assert!(gain[0] > 1.0 && (gain[0] - gain[1]).abs() < 1e-8 * gain[0]);
    assert!(ahead.shift.is_none());
    let between = placed.state[1] - placed.state[0];
    assert!((between - ahead.state[0]).abs() < 1e-7 * between);
    let [one, other] = [&placed.floquet, &ahead.floquet].map(|one| one.multipliers[0]);
    assert!((one - other).norm() < 1e-7, "{one} {other}");
}
