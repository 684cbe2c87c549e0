//! Curves of borders in two parameters: where they are known in closed form, and against branches in one parameter.

use std::f64::consts::FRAC_PI_2;

use stickslip::model;
use stickslip::model::Model;
use stickslip::study::{CurveRecord, Dynamics, Kind, System};
use stickslip_models::friction::Coulomb;
use stickslip_models::press::{Compliant, Rigid};
use stickslip_tests::branches::{branch, named, question};

use crate::borders::Torn;

model! {
    /// A mass on a damped spring, shaken, beside a wall.
    struct Walled {
        state x = 0.0;
        state v = 0.0;
        param gap = 2.0;
        param push = 0.5;
        param omega = 0.8;
        param rebound = 0.7 where 0.0 <= rebound <= 1.0;
        drive phi at omega;
        press N = Rigid { restitution: rebound } closing gap - x;
        der(x) = v;
        der(v) = push * cos(phi) - x - 0.2 * v - N;
    }
}

model! {
    /// A mass that is pushed to and fro on rough ground.
    struct Pushed {
        state v = 0.0;
        param push = 1.0;
        param level = 0.3;
        drive phi at 1.7;
        friction F = Coulomb { level } opposing v;
        der(v) = push * cos(phi) + F;
    }
}

model! {
    /// A head that rubs in its frame below a wire of periodic stiffness.
    struct Pantograph {
        state x = 0.1;
        state v = 0.0;
        state y = 0.1;
        state w = 0.0;
        param alpha = 0.4;
        param omega = 0.6 where omega > 0.0;
        drive phi at omega;
        press N = Compliant { stiffness: 1.0, damping: 0.02 } closing -x;
        friction F = Coulomb { level: 0.03 } opposing v - w;
        let spring = 2.0 * (x - y);
        der(x) = v;
        der(v) = (-spring - 0.05 * v + F - (1 - alpha * cos(phi)) * N) / 0.3;
        der(y) = w;
        der(w) = 0.2 + spring - F - 0.1 * w;
    }
}

/// The curve of the special point of this label on the branch along a parameter, in another one.
fn curve<M: Model<N>, const N: usize>(
    of: &str,
    along: (&str, f64, f64),
    and: (&str, f64, f64),
    accuracy: f64,
) -> CurveRecord {
    let system = System::of::<M, N>();
    let (mut case, mut scope) = question(&system, Dynamics::Exact, along, and);
    (case.accuracy, scope.of) = (accuracy, Some(of.to_owned()));
    let found = system.curve(&case, &scope);
    found.expect("a curve").followed().expect("all of it")
}

fn lies_on(curve: &CurveRecord, expected: impl Fn(f64) -> f64, tolerance: f64) {
    assert!(curve.ended.is_located(), "{}", curve.ended.reason);
    assert!(curve.points.len() > 3, "{} points", curve.points.len());
    for point in &curve.points {
        let off = point.p / expected(point.q) - 1.0;
        assert!(off.abs() <= tolerance, "{} {}: {off:e}", point.p, point.q);
    }
}

/// The wall is touched where the linear response is as large as the gap.
#[test]
fn a_graze_of_a_wall_follows_the_linear_response() {
    let response = |omega: f64| (1.0 - omega.powi(2)).hypot(0.2 * omega).recip();
    for accuracy in [1e-6, 1e-9] {
        let along = ("push", 0.5, 2.0);
        let found = curve::<Walled, _>("GR1", along, ("omega", 0.8, 1.3), accuracy);
        assert_eq!(found.kind, Kind::Grazing);
        lies_on(&found, |omega| 2.0 / response(omega), accuracy);
        let found = curve::<Walled, _>("GR1", along, ("gap", 2.0, 1.0), accuracy);
        lies_on(&found, |gap| gap / response(0.8), accuracy);
    }
}

/// It slides through its turning points as long as the push there, √(1 − (π β/2)²) of its largest, is more than β, the limit of
/// friction as a share of that.
#[test]
fn where_a_mass_begins_to_stick_follows_the_push() {
    for accuracy in [1e-6, 1e-9] {
        let found = curve::<Pushed, _>("CS1", ("level", 0.3, 0.7), ("push", 1.0, 2.5), accuracy);
        assert_eq!(found.kind, Kind::CrossingSliding);
        lies_on(&found, |push| push / 1.0_f64.hypot(FRAC_PI_2), accuracy);
    }
}

/// Where a plate between two belts ceases to stick to one, as a branch at the end of the curve has it.
#[test]
fn where_a_plate_switches_follows_the_other_belt() {
    let found = curve::<Torn, _>("SS1", ("above", 0.3, 0.1), ("below", 0.7, 0.65), 1e-9);
    assert_eq!(found.kind, Kind::SwitchingSliding);
    assert!(found.ended.is_located(), "{}", found.ended.reason);
    let last = found.points.last().expect("points");
    let there = branch(&[(Torn::below, last.q)], Torn::above, (0.3, 0.1), |_| {});
    let (on, off) = (there.special[0].r, last.p);
    assert_eq!(there.special[0].kind, Kind::SwitchingSliding);
    assert!((on / off - 1.0).abs() < 1e-8, "{on} {off}");
}

/// On its way along the curve the contact begins to leave the wire, at first next to the border: it is not held on there.
#[test]
fn a_curve_goes_on_where_another_contact_comes_between() {
    let found = curve::<Pantograph, _>("GS1", ("omega", 0.6, 0.72), ("alpha", 0.4, 0.31), 1e-9);
    assert_eq!(found.kind, Kind::GrazingSliding);
    assert!(found.ended.is_located(), "{}", found.ended.reason);
    let last = found.points.last().expect("points");
    let alpha = [(Pantograph::alpha, last.q)];
    let there = branch(&alpha, Pantograph::omega, (0.6, 0.8), |_| {});
    let off = |r: f64| (r / last.p - 1.0).abs();
    let nearest = there
        .special
        .iter()
        .map(|one| off(one.r))
        .fold(1.0, f64::min);
    assert!(nearest < 1e-8, "{} {:?}", last.p, named(&there));
}
