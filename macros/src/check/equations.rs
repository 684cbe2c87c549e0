//! Equations: one for each state, and linear in the friction forces.

use std::collections::HashMap;

use proc_macro2::Ident;

use super::names::Names;
use crate::errors::Errors;
use crate::formula::{Formula, Kind, Operator};
use crate::suggest::nearest;
use crate::syntax::{Broken, Declaration, Friction, Line};

/// A model has at least one state.
pub(super) fn check_a_state(written: &Declaration, errors: &mut Errors) {
    let broken = written.broken().any(|line| line.keyword != Some("param"));
    if written.states().next().is_none() && !broken {
        errors.at(
            &written.name,
            format!(
                "model `{}` has no state: add `state x = 1.0;`",
                written.name
            ),
        );
    }
}

/// `der(..)` is of a state.
pub(super) fn check_left_sides(written: &Declaration, names: &Names, errors: &mut Errors) {
    let states = state_names(written);
    for derivative in written.derivatives() {
        let name = derivative.state.to_string();
        let said = super::arrays::missing(written).any(|element| element.name == derivative.state);
        if !states.contains(&name) && !said {
            let advice = not_a_state(&derivative.state, names, &states, "have equations");
            errors.at(&derivative.state, format!("`{name}` is {advice}"));
        }
    }
}

/// What is to be said of a name that stands where a state is needed.
pub(super) fn not_a_state(
    name: &Ident,
    names: &Names,
    states: &[String],
    only_states: &str,
) -> String {
    if let Some(noun) = names.noun_of(name) {
        return format!("a {noun}, not a state; only states {only_states}");
    }
    match nearest(&name.to_string(), states.iter().map(String::as_str)) {
        Some(near) => format!("not a state; did you mean `{near}`?"),
        None if names.in_model => format!("not a state; declare it with `state {name} = 0.0;`"),
        None => format!("not a state; declare it with `state {name};`"),
    }
}

/// Each state has one equation.
pub(super) fn check_one_equation_each(written: &Declaration, errors: &mut Errors) {
    let lost = written
        .broken()
        .any(|line| line.keyword == Some("der") && line.name.is_none());
    let lost = lost || super::memory::misnamed(written).next().is_some();
    for state in written.states() {
        let name = &state.name;
        let equations: Vec<&Ident> = left_sides(written).filter(|left| *left == name).collect();
        let carries = |friction: &Friction| friction.memory.contains(name);
        if equations.is_empty() && !lost && !written.frictions().any(carries) {
            errors.at(
                name,
                format!("state `{name}` has no equation: add `der({name}) = ...;`"),
            );
        }
        for second in equations.iter().skip(1) {
            errors.at(
                second,
                format!("second equation for `der({name})`; keep one"),
            );
        }
    }
}

/// The names of all states, of broken lines too.
pub(super) fn state_names(written: &Declaration) -> Vec<String> {
    states(written).map(ToString::to_string).collect()
}

fn states(written: &Declaration) -> impl Iterator<Item = &Ident> {
    let whole = written.states().map(|state| &state.name);
    whole.chain(broken_names(written, "state"))
}

fn left_sides(written: &Declaration) -> impl Iterator<Item = &Ident> {
    let whole = written.derivatives().map(|derivative| &derivative.state);
    whole.chain(broken_names(written, "der"))
}

fn broken_names<'a>(written: &'a Declaration, keyword: &'a str) -> impl Iterator<Item = &'a Ident> {
    let of_kind = move |line: &&Broken| line.keyword == Some(keyword);
    written
        .broken()
        .filter(of_kind)
        .filter_map(|line| line.name.as_ref())
}

/// A law has one line for rest and one for sliding.
pub(super) fn check_stick_and_slip(written: &Declaration, errors: &mut Errors) {
    let broken = |keyword: &str| written.broken().any(|line| line.keyword == Some(keyword));
    let name = &written.name;
    if written.sticks().next().is_none() && !broken("stick") {
        errors.at(
            name,
            format!("law `{name}` has no force at rest: add `stick = ...;`"),
        );
    }
    if written.slips().next().is_none() && !broken("slip") {
        errors.at(
            name,
            format!("law `{name}` has no force while sliding: add `slip(s) = ...;`"),
        );
    }
    for second in written.sticks().skip(1) {
        errors.at(&second.word, "second `stick` line; keep one");
    }
    for second in written.slips().skip(1) {
        errors.at(&second.word, "second `slip` line; keep one");
    }
}

/// How a formula depends on the friction forces.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Dependence {
    Free,
    Linear,
}

/// Which names carry a friction force, directly or through `let` lines.
struct Forces<'a> {
    carried: HashMap<&'a Ident, Dependence>,
}

impl<'a> Forces<'a> {
    /// Follows the lines from top to bottom; reports every product of forces to `errors`.
    fn of(written: &'a Declaration, mut errors: Option<&mut Errors>) -> Self {
        let mut forces = Self {
            carried: HashMap::new(),
        };
        for line in &written.lines {
            match line {
                Line::Friction(friction) if friction.memory.is_empty() => {
                    forces.carried.insert(&friction.name, Dependence::Linear);
                }
                Line::Let(quantity) => {
                    let dependence = forces.dependence(&quantity.formula, &mut errors);
                    forces.carried.insert(&quantity.name, dependence);
                }
                _ => {}
            }
        }
        for derivative in written.derivatives() {
            forces.dependence(&derivative.formula, &mut errors);
        }
        forces
    }

    fn dependence(&self, formula: &Formula, errors: &mut Option<&mut Errors>) -> Dependence {
        let parts = formula.parts();
        let of_parts: Vec<Dependence> = parts
            .iter()
            .map(|part| self.dependence(part, errors))
            .collect();
        let strongest = of_parts.iter().copied().max().unwrap_or(Dependence::Free);
        let keeps = match &formula.kind {
            Kind::Name(name) => return self.carried.get(name).copied().unwrap_or(Dependence::Free),
            Kind::Group(_) | Kind::Minus(_) => true,
            Kind::Binary(_, Operator::Add | Operator::Subtract, _) => true,
            Kind::Binary(_, Operator::Multiply, _) => of_parts.contains(&Dependence::Free),
            Kind::Binary(_, Operator::Divide, _) => of_parts[1] == Dependence::Free,
            _ => false,
        };
        if strongest == Dependence::Free || keeps {
            return strongest;
        }
        if let Some(errors) = errors {
            errors.at(formula, format!("`{formula}`: {NONLINEAR}"));
        }
        Dependence::Free
    }
}

const NONLINEAR: &str = "friction forces must enter linearly, so that the sticking force can be solved for; \
     here one is multiplied by a force, stands in a denominator or inside a function";

/// Friction forces enter the equations linearly.
pub(super) fn check_forces_linear(written: &Declaration, errors: &mut Errors) {
    Forces::of(written, Some(errors));
}

/// The speed of a contact and the fields of its law depend on no friction force.
pub(super) fn check_laws_read_no_force(written: &Declaration, errors: &mut Errors) {
    let forces = Forces::of(written, None);
    for friction in written.frictions() {
        let fields = friction.fields.iter().map(|field| &field.formula);
        for name in fields.chain([&friction.speed]).flat_map(Formula::names) {
            if *name != friction.name && forces.carried.get(name) == Some(&Dependence::Linear) {
                let own = &friction.name;
                errors.at(name, format!(
                    "`{name}` is or contains a friction force, and the law and speed of `{own}` cannot depend on one: \
                     a normal force is a formula of states and parameters"
                ));
            }
        }
    }
}
