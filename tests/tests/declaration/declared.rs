//! What `model!` and `friction_law!` make of a declaration, as numbers.

use stickslip::friction::{ContactRule, FrictionLaw};
use stickslip::model::Model;
use stickslip::scalar::Scalar;
use stickslip_models::friction::{CoulombStatic, Stribeck, Weakening};
use stickslip_models::{BeltOscillator, BeltPair, DrillString, VanDerPol};

/// Gives the contacts these forces, and notes who asks with which law and speed.
#[derive(Default)]
struct Given {
    forces: Vec<f64>,
    asked: Vec<(usize, &'static str, f64, f64)>,
}

impl Given {
    fn forces(forces: &[f64]) -> Self {
        Self {
            forces: forces.to_vec(),
            ..Self::default()
        }
    }
}

impl<D: Scalar> ContactRule<D> for Given {
    fn force<L: FrictionLaw<D>>(&mut self, contact: usize, law: &L, speed: D) -> D {
        self.asked
            .push((contact, L::INFO.name, law.stick().re(), speed.re()));
        D::from(self.forces[contact])
    }
}

#[test]
fn right_sides_are_as_written() {
    let f = VanDerPol::rhs(&[2.0], [0.5, 0.1], &mut Given::default());
    assert_eq!(f, [0.1, -2.0 * (0.5 * 0.5 - 1.0) * 0.1 - 0.5]);

    let belt = BeltOscillator {
        m: 2.0,
        k: 3.0,
        ..Default::default()
    };
    let f = BeltOscillator::rhs(&belt.values(), [0.5, 0.1], &mut Given::forces(&[0.7]));
    assert_eq!(f, [0.1, (0.7 - 3.0 * 0.5) / 2.0]);

    let mut forces = Given::forces(&[0.3, 0.4]);
    let f = BeltPair::rhs(&[1.2, 1.3, 3.0, 0.14], [0.5, 0.1, 0.2, 0.6], &mut forces);
    let coupling = 1.2 * (0.5 - 0.2);
    assert_eq!(f, [0.1, -0.5 - coupling + 0.3, 0.6, -0.2 + coupling + 0.4]);

    let mut forces = Given::forces(&[-7.0]);
    let f = DrillString::rhs(&[4.0, 4.2, 3.0, 0.05], [0.5, 0.1], &mut forces);
    assert_eq!(f, [0.1, -2.0 * 0.05 * 0.1 - 0.5 - (-7.0 + 3.0)]);
}

#[test]
fn each_contact_is_asked_once_in_the_order_of_declaration() {
    let mut rule = Given::forces(&[0.0, 0.0]);
    let (parameters, state) = ([1.2, 1.3, 3.0, 0.14], [0.5, 0.1, 0.2, 0.6]);
    BeltPair::rhs(&parameters, state, &mut rule);
    let expected = vec![
        (0, "Weakening", 1.0, 0.1 - 0.14),
        (1, "Weakening", 1.3, 0.6 - 0.14),
    ];
    assert_eq!(rule.asked, expected);
    rule.asked.clear();
    BeltPair::observables(&parameters, state, &mut rule);
    assert_eq!(rule.asked, expected);
}

#[test]
fn observables_are_the_let_lines() {
    let mut rule = Given::forces(&[-7.0]);
    let observed = DrillString::observables(&[4.0, 4.2, 3.0, 0.05], [0.5, 0.1], &mut rule);
    assert_eq!(observed, [4.0]);
    let none: [f64; 0] = VanDerPol::observables(&[1.0], [0.5, 0.1], &mut Given::default());
    assert!(none.is_empty());
}

#[test]
fn kinematic_rows_are_known() {
    assert_eq!(VanDerPol::KINEMATIC, [Some(1), None]);
    assert_eq!(BeltOscillator::KINEMATIC, [Some(1), None]);
    assert_eq!(BeltPair::KINEMATIC, [Some(1), None, Some(3), None]);
    assert_eq!(DrillString::KINEMATIC, [Some(1), None]);
}

#[test]
fn sparsity_goes_through_contacts_and_let_lines() {
    let both = [[false, true], [true, true]];
    assert_eq!(VanDerPol::SPARSITY, both);
    assert_eq!(BeltOscillator::SPARSITY, both);
    assert_eq!(DrillString::SPARSITY, both);
    assert_eq!(
        BeltPair::SPARSITY,
        [
            [false, true, false, false],
            [true, true, true, false],
            [false, false, false, true],
            [true, false, true, true],
        ]
    );
}

#[test]
fn a_model_is_a_plain_struct_of_its_parameters() {
    let belt = BeltOscillator {
        v_dr: 0.1,
        ..Default::default()
    };
    assert_eq!(belt.values(), [1.0, 1.0, 0.1, 1.0, 3.0]);
    assert_eq!(BeltOscillator::from_values(belt.values()), belt);
    assert_eq!(
        format!("{belt:?}"),
        "BeltOscillator { m: 1.0, k: 1.0, v_dr: 0.1, F_s: 1.0, delta: 3.0 }"
    );
}

#[test]
fn handles_name_places() {
    let handles = [
        BeltOscillator::m,
        BeltOscillator::k,
        BeltOscillator::v_dr,
        BeltOscillator::F_s,
        BeltOscillator::delta,
    ];
    assert_eq!(handles.map(|handle| handle.index), [0, 1, 2, 3, 4]);
}

#[test]
fn laws_are_numbers() {
    let weakening = Weakening {
        limit: 2.0,
        decay: 3.0,
    };
    assert_eq!((weakening.stick(), weakening.slip(1.0)), (2.0, 0.5));
    let drop = CoulombStatic {
        static_level: 2.0,
        kinetic_level: 1.0,
    };
    assert_eq!((drop.stick(), drop.slip(0.1)), (2.0, 1.0));
    let curve = Stribeck {
        static_level: 2.0,
        kinetic_level: 1.0,
        speed: 0.5,
        exponent: 2.0,
        viscous: 0.1,
    };
    assert_eq!((curve.stick(), curve.slip(0.0)), (2.0, 2.0));
    let expected = 1.0 + (-4.0f64).exp() + 0.1;
    assert!((curve.slip(1.0) - expected).abs() < 1e-15);
}
