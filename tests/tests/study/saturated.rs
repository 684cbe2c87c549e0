//! Internal states that keep still in their saturation while all else swings: they are measured in what they are, and where the
//! speed of their law is that of a dry contact, its sign is that of the contact.

use stickslip::field::Design;
use stickslip::model;
use stickslip::model::{Model as _, ParamId};
use stickslip::study::{Along, Case, Dynamics, System};
use stickslip_models::friction::{Dahl, Tustin};

model! {
    /// A drawer on a dry guide with a seal that yields, pulled by a hand through a spring.
    pub struct Drawer {
        state pull: m = 0.0;
        state v: m/s = 0.0;
        state z: m = 0.0;
        param m: kg = 3.0 where m > 0.0;
        param k: N/m = 200.0;
        param hand: m/s = 0.02;
        param dry: N = 6.0 where dry >= 0.0;
        param seal: N = 2.0 where seal > 0.0;
        friction F: N = Tustin { static_level: dry, kinetic_level: 0.6 * dry, speed: 0.01, viscous: 1.0 } opposing v;
        friction S: N = Dahl { stiffness: 1e4, level: seal } opposing v with z;
        der(pull) = hand - v;
        der(v) = (k * pull + F + S) / m;
    }
}

fn case(along: ParamId<Drawer>, to: f64) -> Case {
    let mut case = Case::declared(Drawer::INFO, Dynamics::Exact);
    let (design, from) = (Design::Parameter(along.index), case.parameters[along.index]);
    case.along = Some(Along { design, from, to });
    case
}

/// The drawer only moves forwards, so that the seal pulls with all that it bears: it shifts the spring, and nothing else.
#[test]
fn a_saturated_seal_shifts_an_orbit_and_nothing_else() {
    let system = System::of::<Drawer, _>();
    for to in [0.3, 6.0] {
        let branch = system.branch(&case(Drawer::seal, to)).unwrap();
        assert!(branch.ended.is_whole(), "{}", branch.ended.reason);
        assert!(branch.points.len() < 100, "{}", branch.points.len());
        let first = &branch.points[0];
        for point in &branch.points {
            let shift = point.max[0] - first.max[0] - (point.r.unwrap() - first.r.unwrap()) / 200.0;
            assert!(shift.abs() < 1e-9, "{shift:e} at {:?}", point.r);
            let period = point.period / first.period - 1.0;
            assert!(period.abs() < 1e-7, "{period:e} at {:?}", point.r);
        }
    }
}

/// It sticks once around, so that the period is the least, and the branches have no end before that of their ranges.
#[test]
fn branches_beside_a_saturated_seal_are_followed() {
    let system = System::of::<Drawer, _>();
    for (along, to) in [
        (Drawer::hand, 0.05),
        (Drawer::hand, 0.01),
        (Drawer::k, 400.0),
        (Drawer::m, 1.0),
    ] {
        let branch = system.branch(&case(along, to)).unwrap();
        assert!(branch.ended.is_whole(), "{}", branch.ended.reason);
        for point in &branch.points {
            assert_eq!(point.period_count, 1, "{point:?}");
            let largest = point.floquet.multipliers[0].norm();
            assert!(largest < 0.05, "{largest} at {:?}", point.r);
        }
    }
    let mut odd = Case::declared(Drawer::INFO, Dynamics::Exact);
    odd.parameters[Drawer::hand.index] = 0.0209;
    let orbit = system.orbit(&odd).unwrap();
    assert!((orbit.period - 1.6155573).abs() < 1e-6, "{}", orbit.period);
}
