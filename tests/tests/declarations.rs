//! What `model!` and `friction_law!` make of a declaration, as data and as numbers.

use stickslip::friction::{ContactRule, FrictionLaw};
use stickslip::model::{Bound, Bounds, Model, ModelInfo};
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
    assert_eq!(none, []);
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
fn names_are_those_of_the_declaration() {
    let names = |info: &ModelInfo| {
        let states = info.states.iter().map(|state| state.name);
        let parameters = info.parameters.iter().map(|parameter| parameter.name);
        states.chain(parameters).collect::<Vec<_>>().join(" ")
    };
    assert_eq!(names(VanDerPol::INFO), "x v nu");
    assert_eq!(names(BeltOscillator::INFO), "x v m k v_dr F_s delta");
    assert_eq!(names(BeltPair::INFO), "x1 v1 x2 v2 alpha beta gamma v_dr");
    assert_eq!(names(DrillString::INFO), "psi omega eta theta kinetic zeta");
    let commands = [
        VanDerPol::INFO,
        BeltOscillator::INFO,
        BeltPair::INFO,
        DrillString::INFO,
    ];
    assert_eq!(
        commands.map(|info| info.command),
        [
            "van-der-pol",
            "belt-oscillator",
            "belt-pair",
            "drill-string"
        ]
    );
    assert_eq!(BeltOscillator::INFO.name, "BeltOscillator");
}

#[test]
fn values_are_those_of_the_declaration() {
    let starts = |info: &ModelInfo| {
        info.states
            .iter()
            .map(|state| state.start)
            .collect::<Vec<_>>()
    };
    assert_eq!(starts(BeltPair::INFO), [-0.5976, 0.0, -0.4604, -0.1607]);
    let defaults = |info: &ModelInfo| {
        let parameters = info.parameters.iter();
        parameters
            .map(|parameter| parameter.default)
            .collect::<Vec<_>>()
    };
    assert_eq!(defaults(BeltPair::INFO), BeltPair::default().values());
    assert_eq!(defaults(DrillString::INFO), [4.0, 4.2, 4.2, 0.05]);
}

#[test]
fn units_are_those_of_the_declaration() {
    let info = BeltOscillator::INFO;
    let states = info.states.iter().map(|state| state.unit);
    let parameters = info.parameters.iter().map(|parameter| parameter.unit);
    let contacts = info.contacts.iter().map(|contact| contact.unit);
    let units = states.chain(parameters).chain(contacts);
    let units: Vec<_> = units
        .map(|unit| unit.map(|unit| (unit.text, unit.dimension)))
        .collect();
    assert_eq!(
        units,
        [
            Some(("m", [1, 0, 0, 0, 0, 0, 0])),
            Some(("m/s", [1, 0, -1, 0, 0, 0, 0])),
            Some(("kg", [0, 1, 0, 0, 0, 0, 0])),
            Some(("N/m", [0, 1, -2, 0, 0, 0, 0])),
            Some(("m/s", [1, 0, -1, 0, 0, 0, 0])),
            Some(("N", [1, 1, -2, 0, 0, 0, 0])),
            Some(("s/m", [-1, 0, 1, 0, 0, 0, 0])),
            Some(("N", [1, 1, -2, 0, 0, 0, 0])),
        ]
    );
    assert!(
        BeltPair::INFO
            .states
            .iter()
            .all(|state| state.unit.is_none())
    );
}

#[test]
fn bounds_are_those_of_the_declaration() {
    let end = |value, inclusive| Some(Bound { value, inclusive });
    let bounds = |lower, upper| Bounds { lower, upper };
    let parameters = BeltOscillator::INFO.parameters.iter();
    let found: Vec<Bounds> = parameters.map(|parameter| parameter.bounds).collect();
    let (above, from) = (bounds(end(0.0, false), None), bounds(end(0.0, true), None));
    assert_eq!(found, [above, above, Bounds::NONE, from, from]);
    let exponent = <Stribeck<f64> as FrictionLaw<f64>>::INFO.parameters[3];
    assert_eq!(exponent.bounds, bounds(end(1.0, true), None));
}

#[test]
fn docs_are_those_of_the_declaration() {
    let info = DrillString::INFO;
    assert_eq!(
        info.doc,
        "Drill string in torsion, nondimensional: thesis section 4.2, (4.6)."
    );
    assert_eq!(
        info.states[0].doc,
        "Twist, measured from the sliding equilibrium."
    );
    assert_eq!(info.parameters[3].doc, "Damping ratio.");
    assert_eq!(info.contacts[0].doc, "Friction torque at the bit.");
    let stribeck = <Stribeck<f64> as FrictionLaw<f64>>::INFO;
    assert_eq!(
        stribeck.doc,
        "Stribeck's curve with a viscous part: Bo and Pavelescu's exponential form.\n\n\
         Exponent 1 is Tustin's law, exponent 2 the Gaussian form. Below 1 the slope at rest is infinite."
    );
}

#[test]
fn formulas_are_shown_as_written() {
    let info = DrillString::INFO;
    assert_eq!(info.states[0].equation, "omega");
    assert_eq!(info.states[1].equation, "-2 * zeta * omega - psi + T_c");
    assert_eq!(info.observables[0].name, "T_c");
    assert_eq!(info.observables[0].formula, "-(T_b + kinetic)");
    let contact = info.contacts[0];
    assert_eq!((contact.name, contact.law.name), ("T_b", "CoulombStatic"));
    assert_eq!(
        contact.fields,
        "static_level: kinetic + theta, kinetic_level: kinetic"
    );
    assert_eq!(contact.speed, "eta - omega");
    assert_eq!(
        VanDerPol::INFO.states[1].equation,
        "-nu * (powi(x, 2) - 1) * v - x"
    );
}

#[test]
fn laws_are_data() {
    let info = <Weakening<f64> as FrictionLaw<f64>>::INFO;
    assert_eq!((info.name, info.stick), ("Weakening", "limit"));
    assert_eq!(info.slip, "limit / (1.0 + decay * s)");
    let parameters: Vec<_> = info
        .parameters
        .iter()
        .map(|parameter| (parameter.name, parameter.unit.map(|unit| unit.text)))
        .collect();
    assert_eq!(parameters, [("limit", Some("N")), ("decay", Some("s/m"))]);
    assert_eq!(info.parameters[0].doc, "Largest static force.");
    assert_eq!(*info, *BeltOscillator::INFO.contacts[0].law);
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
