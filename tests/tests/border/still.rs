//! Equilibria where friction holds little more, or nothing at all.

use stickslip::bifurcation::Stability;
use stickslip::continuation::Kind;
use stickslip::field::Design;
use stickslip::model;
use stickslip::model::Model;
use stickslip::study::{Along, Case, Dynamics, System};
use stickslip_models::friction::{Coulomb, Weakening};

model! {
    /// A valve that sticks between a tank and a controller with integral action.
    struct Sticking {
        state x = 0.0;
        state v = 0.0;
        state h = 0.0;
        state i = 0.1;
        friction F = Coulomb { level: 1.0 } opposing v;
        der(x) = v;
        der(v) = 50.0 * (0.5 * (i / 20.0 - h) - x) + F;
        der(h) = (2.0 * x - h) / 10.0;
        der(i) = -h;
    }
}

model! {
    /// A mass with a damper and a dry one, which may be taken away.
    struct Freed {
        state x = 0.3;
        state v = 0.0;
        param damping = -0.2;
        param dry = 0.0 where dry >= 0.0;
        friction F = Coulomb { level: dry } opposing v;
        der(x) = v;
        der(v) = F - 4.0 * x - damping * v;
    }
}

/// The stem may stand anywhere for a while: h decays as e^(−t/10), i drifts.
#[test]
fn a_set_along_which_something_drifts_is_not_called_stable() {
    let system = System::of::<Sticking, 4>();
    let case = Case::declared(Sticking::INFO, Dynamics::Exact);
    let found = system.equilibria(&case).expect("a set");
    let [set] = &found[..] else {
        panic!("{found:?}")
    };
    assert_eq!(set.stability, Stability::Undecided, "{set:?}");
    let [zero, decays] = set.eigenvalues[..] else {
        panic!("{set:?}")
    };
    assert_eq!(zero.norm(), 0.0);
    assert!((decays.re + 0.1).abs() < 1e-12, "{decays}");
}

/// λ² + c λ + 4 = 0: it begins to swing at c = 0, with the frequency 2.
#[test]
fn without_its_friction_it_has_the_equilibria_of_the_rest() {
    let system = System::of::<Freed, 2>();
    let mut case = Case::declared(Freed::INFO, Dynamics::Exact);
    let found = system.equilibria(&case).expect("one");
    let [one] = &found[..] else {
        panic!("{found:?}")
    };
    assert_eq!(one.stability, Stability::Unstable);
    assert!((one.eigenvalues[0].re - 0.1).abs() < 1e-12);
    case.along = Some(Along {
        design: Design::Parameter(Freed::damping.index),
        from: -0.2,
        to: 0.3,
    });
    let branch = system.equilibria_along(&case).expect("a branch");
    let [hopf] = &branch.special[..] else {
        panic!("{:?}", branch.special)
    };
    assert_eq!(hopf.kind, Kind::Hopf);
    assert!(hopf.r.abs() < 1e-9, "{}", hopf.r);
    assert_eq!(branch.points.last().and_then(|point| point.r), Some(0.3));
}

model! {
    /// A damped mass that swings to rest beside one that sticks and slips on a belt for ever; neither feels the other.
    struct Apart {
        state x: 1 = 1.0;
        state v: 1 = 0.0;
        state y: 1 = 0.0;
        state w: 1 = 0.0;
        param belt: 1 = 0.2;
        friction F: 1 = Weakening { limit: 1.0, decay: 3.0 } opposing w - belt;
        der(x) = v;
        der(v) = -x - v;
        der(y) = w;
        der(w) = F - y;
    }
}

/// It was told as rest, since the first state had come to it.
#[test]
fn what_moves_beside_a_state_at_rest_is_no_equilibrium() {
    let found = System::of::<Apart, _>().orbit(&Case::of(&Apart::default()));
    let told = found.map_or_else(|error| error.to_string(), |orbit| orbit.period.to_string());
    assert!(!told.contains("equilibrium"), "{told}");
}
