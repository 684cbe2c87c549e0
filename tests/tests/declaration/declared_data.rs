//! What `model!` and `friction_law!` make of a declaration, as data.

use stickslip::friction::FrictionLaw;
use stickslip::model::{Bound, Bounds, Model, ModelInfo};
use stickslip_models::friction::{Stribeck, Weakening};
use stickslip_models::{BeltOscillator, BeltPair, DrillString, VanDerPol};

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
            Some(("m", [12, 0, 0, 0, 0, 0, 0])),
            Some(("m/s", [12, 0, -12, 0, 0, 0, 0])),
            Some(("kg", [0, 12, 0, 0, 0, 0, 0])),
            Some(("N/m", [0, 12, -24, 0, 0, 0, 0])),
            Some(("m/s", [12, 0, -12, 0, 0, 0, 0])),
            Some(("N", [12, 12, -24, 0, 0, 0, 0])),
            Some(("s/m", [-12, 0, 12, 0, 0, 0, 0])),
            Some(("N", [12, 12, -24, 0, 0, 0, 0])),
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
         With F_s = `static_level`, F_c = `kinetic_level` ≤ F_s, v_s = `speed`, a = `exponent`, σ = `viscous`:\n\n\
         |F| ≤ F_s at rest, F_c + (F_s − F_c) exp(−(s/v_s)^a) + σ s at the sliding speed s\n\n\
         Exponent 1 is Tustin's law, exponent 2 the Gaussian form; below 1 the slope at rest would be infinite.\n\n\
         Source: L. C. Bo, D. Pavelescu, Wear 82, 1982."
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
