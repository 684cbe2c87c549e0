//! What copies get wrong of motions that run on is predicted, too: but for where they are.

use stickslip::field::Kernel;
use stickslip::model;
use stickslip::study::trade::{Curve, Scope};
use stickslip::study::{Case, Dynamics, System};
use stickslip_models::friction::Coulomb;

model! {
    /// A slider on a stage that moves by a saw tooth of two harmonics: at its fastest it sticks, and nothing pulls.
    pub struct InertiaDrive {
        state v = 0.0;
        state place = 0.0;
        param dry = 0.4 where dry >= 0.0;
        drive phi at 1.0;
        let stage = cos(phi) - 0.5 * cos(2.0 * phi);
        friction F = Coulomb { level: dry } opposing v - stage;
        der(v) = F;
        der(place) = v;
    }
}

model! {
    /// A mass that is held less one way than the other, and so gets on: farthest where its lap ends.
    pub struct OneWay {
        state v = 0.0;
        state x = 0.0;
        param forth = 0.2 where forth >= 0.0;
        param back = 0.6 where back >= 0.0;
        drive phi at 1.0;
        friction F = Coulomb { level: 0.5 * (forth + back) } opposing v;
        der(v) = F + 0.5 * (back - forth) + cos(phi);
        der(x) = v;
    }
}

/// Copies of sizes for which what they get wrong is small.
fn fine(system: &System, kernel: Kernel) -> Curve {
    let scope = Scope {
        kernels: vec![kernel],
        sign_sizes: vec![1e4, 1e5, 1e6],
        tolerances: Vec::new(),
        ..Scope::default()
    };
    let case = Case::declared(system.info(), Dynamics::Exact);
    let mut ends = system.trade(&case, &scope).unwrap().ends;
    ends.remove(0).trade.curves.remove(0)
}

/// The errors of these states are as predicted, of copies of each size.
fn are_predicted(curve: &Curve, states: &[usize]) {
    assert_eq!(curve.points.len(), 3, "{:?}", curve.lost);
    for point in &curve.points {
        let predicted = point.predicted.as_ref().unwrap();
        for &j in states {
            let ratio = predicted.max_abs[j].unwrap() / point.max_abs[j];
            assert!((ratio - 1.0).abs() < 0.03, "{} {j}: {ratio}", point.size);
        }
    }
}

#[test]
fn copies_of_what_crawls_are_predicted_where_it_begins_its_lap() {
    let (crawl, drive) = (System::of::<OneWay, _>(), System::of::<InertiaDrive, _>());
    for kernel in [Kernel::Arctan, Kernel::Cubic] {
        are_predicted(&fine(&crawl, kernel), &[0, 1]);
        let curve = fine(&drive, kernel);
        are_predicted(&curve, &[1]);
        // The error of the speed at which it sticks is of second order.
        for point in &curve.points {
            assert_eq!(point.predicted.as_ref().unwrap().max_abs[0], None);
            assert!(point.max_abs[0].abs() < 1e-6, "{point:?}");
        }
    }
}
