//! Walls as penalty springs: what a copy of an impact gets wrong, against closed forms.

use std::f64::consts::TAU;

use stickslip::field::{Design, Kernel, SmoothField, Smoothing};
use stickslip::flow::{Flow, SmoothFlow, Want};
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip::study::trade::Scope;
use stickslip::study::{Case, Dynamics, System};

use crate::models::{Hammer, copy, falls};

/// A free mass of any size comes back from its wall with the share e of its speed. What the turn takes is of the speed
/// 1/√ε, and the energy in question of its square.
#[test]
fn a_penalty_spring_keeps_the_restitution_to_the_order_of_its_size() {
    for kernel in [Kernel::Tanh, Kernel::Cubic, Kernel::Quintic] {
        for e in [0.3, 0.6, 0.95] {
            for v in [0.7, 2.1] {
                let hammer = Hammer {
                    load: 0.0,
                    c: 0.0,
                    k: 1e-12,
                    e,
                    ..Default::default()
                };
                let error = |size: f64| {
                    let flow = copy(&hammer, Smoothing { kernel, size }, Design::None);
                    let place = flow.place([0.0, v, 0.0]).unwrap();
                    let end = flow.advance(&place, 4.0, Want::default()).unwrap().end;
                    -end.state[1] / v - e
                };
                let ratio = falls([1e4, 1e5], error);
                assert!((ratio - 10.0).abs() < 0.1, "{kernel} {e} {v}: {ratio}");
                assert!(error(1e7).abs() < 1e-6, "{kernel} {e} {v}");
            }
        }
    }
}

fn case(hammer: &Hammer) -> Case {
    let mut case = Case::declared(Hammer::INFO, Dynamics::Exact);
    case.parameters = hammer.values().as_ref().to_vec();
    case.start = Some(vec![0.9, -1.36, 0.0]);
    case.accuracy = 1e-10;
    case
}

/// A wall of the stiffness ε holds its impact for π/√ε and gives way by v/√ε: both are errors of that order.
#[test]
fn the_copy_of_an_impact_orbit_tends_to_its_closed_form() {
    let (system, hammer) = (System::of::<Hammer, 3>(), Hammer::default());
    let exact = system.orbit(&case(&hammer)).unwrap();
    let at = |kernel: Kernel, size: f64| {
        let mut copied = case(&hammer);
        copied.dynamics = Dynamics::Smoothed(Smoothing { kernel, size });
        copied.start = Some(exact.state.clone());
        copied.period = Some(TAU);
        system.orbit(&copied).unwrap()
    };
    for kernel in [Kernel::Tanh, Kernel::Cubic, Kernel::Quintic, Kernel::Arctan] {
        let phase = falls([1e6, 1e8], |size| {
            at(kernel, size).state[0] - exact.state[0]
        });
        assert!((phase - 10.0).abs() < 0.01, "{kernel}: {phase}");
        let deep = falls([1e6, 1e8], |size| at(kernel, size).max[0] - 1.0);
        assert!((deep - 10.0).abs() < 0.02, "{kernel}: {deep}");
        // v/√(1 + ρ) of the stiffness that it meets, ρ = (1 − e²)/(1 + e²): the approach of contacts.md, a3.
        let loss: f64 = 0.36 / 1.64;
        let closed = 1.6957329375948809 / ((1.0 + loss) * 1e8).sqrt();
        let found = at(kernel, 1e8).max[0] - 1.0;
        assert!(
            (found / closed - 1.0).abs() < 2e-3,
            "{kernel}: {found} {closed}"
        );
        let determinant = |size: f64| {
            let multipliers = at(kernel, size).floquet.multipliers;
            multipliers.iter().product::<nalgebra::Complex<f64>>().re
        };
        let determinant = determinant(1e6);
        assert!(
            (determinant - 0.34143237829830614).abs() < 1e-4,
            "{kernel}: {determinant}"
        );
    }
}

/// A bounce too shallow for a step to feel is felt all the same, however weak the tolerance.
#[test]
fn no_wall_is_stepped_over() {
    let hammer = Hammer {
        load: 0.0,
        c: 0.0,
        ..Default::default()
    };
    for k in 1..40 {
        let high = 1.0 + 1e-4 * f64::from(k);
        let smoothing = "quintic:1e7".parse().unwrap();
        let field = SmoothField::new(&hammer, Some(smoothing), Design::None).unwrap();
        let loose = Tolerance::for_accuracy(1e-6);
        let flow = SmoothFlow::new(field, loose);
        let place = flow.place([0.0, high, 0.0]).unwrap();
        let end = flow.advance(&place, 2.5, Want::default()).unwrap().end;
        let [x, v, _] = end.state;
        let (before, after) = (high * high, x * x + v * v);
        let hit = before - 1.0;
        assert!(
            (before - after - 0.36 * hit).abs() < 0.05 * hit + 1e-5,
            "{high}: {before} {after}"
        );
    }
}

/// How stiff a penalty contact must be for an accuracy.
#[test]
fn a_trade_tells_how_stiff_a_wall_must_be() {
    let scope = Scope {
        kernels: vec![Kernel::Quintic],
        sign_sizes: vec![1e4, 1e5, 1e6, 1e7],
        tolerances: vec![1e-6],
        accuracy: Some(1e-3),
        ..Scope::default()
    };
    let system = System::of::<Hammer, 3>();
    let record = system.trade(&case(&Hammer::default()), &scope).unwrap();
    let [end] = record.ends.as_slice() else {
        panic!("{record:?}");
    };
    let [curve] = end.trade.curves.as_slice() else {
        panic!("{record:?}");
    };
    assert!(
        curve.lost.is_empty() && curve.points.len() == 4,
        "{curve:?}"
    );
    let order = curve.max_abs[0].unwrap().a;
    assert!((order + 0.5).abs() < 0.01, "{order}");
    for point in &curve.points {
        assert!((point.stiffness / point.size.sqrt() - 1.0).abs() < 1e-12);
        assert!(point.frequency.abs() < 1e-9 && point.predicted.is_err());
    }
    let need = curve.need.clone().unwrap().unwrap();
    assert!((8e-4..=9e-4).contains(&need.error), "{need:?}");
    assert!(need.setting.error <= 1e-3, "{need:?}");
    let [first, .., last] = curve.points.as_slice() else {
        panic!("{curve:?}");
    };
    assert!(
        (first.size..last.size).contains(&need.smoothing.size),
        "{need:?}"
    );
}
