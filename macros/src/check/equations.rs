//! Equations: one for each state, and linear in the friction forces.

use std::collections::HashSet;

use proc_macro2::Ident;

use super::names::Names;
use crate::errors::Errors;
use crate::formula::{Formula, Kind, Operator};
use crate::suggest::nearest;
use crate::syntax::{Declaration, Friction, Line, Rule};

/// A model has at least one state.
pub(super) fn check_a_state(written: &Declaration, errors: &mut Errors) {
    let broken = written.broken().any(|line| line.keyword != Some("param"));
    if written.states().next().is_none() && !broken {
        let name = &written.header.name;
        errors.at(
            name,
            format!("model `{name}` has no state: add `state x = 1.0;`"),
        );
    }
}

/// `der(..)` is of a state.
pub(super) fn check_left_sides(written: &Declaration, names: &Names, errors: &mut Errors) {
    let states = state_names(written);
    for derivative in written.derivatives() {
        let name = &derivative.name;
        let said = super::arrays::missing(written).any(|element| element.name == *name);
        if !said {
            let only = "not a state; only states have equations";
            check_a_state_named(name, names, &states, only, errors);
        }
    }
}

/// This name is that of a state.
pub(super) fn check_a_state_named(
    name: &Ident,
    names: &Names,
    states: &[String],
    only: &str,
    errors: &mut Errors,
) {
    let text = name.to_string();
    if states.contains(&text) || names.doubt(name) {
        return;
    }
    let advice = if let Some(noun) = names.noun_of(name) {
        format!("a {noun}, {only}")
    } else if let Some(near) = nearest(&text, states.iter().map(String::as_str)) {
        format!("not a state; did you mean `{near}`?")
    } else {
        let start = if names.in_model { " = 0.0" } else { "" };
        format!("not a state; declare it with `state {text}{start};`")
    };
    errors.at(name, format!("`{text}` is {advice}"));
}

/// Each state has one equation.
pub(super) fn check_one_equation_each(written: &Declaration, errors: &mut Errors) {
    let lost = written
        .broken()
        .any(|line| line.keyword == Some("der") && line.name.is_none());
    let lost = lost || super::memory::misnamed(written).next().is_some();
    for state in written.states() {
        let name = &state.name;
        let equations = written.named("der").filter(|left| *left == name);
        let equations: Vec<&Ident> = equations.collect();
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
    written.named("state").map(ToString::to_string).collect()
}

/// A law has one line for rest and one for sliding.
pub(super) fn check_stick_and_slip(written: &Declaration, errors: &mut Errors) {
    let name = &written.header.name;
    if written.sticks().next().is_none() && !written.lost("stick") {
        errors.at(
            name,
            format!("law `{name}` has no force at rest: add `stick = ...;`"),
        );
    }
    if written.slips().next().is_none() && !written.lost("slip") {
        errors.at(
            name,
            format!("law `{name}` has no force while sliding: add `slip(s) = ...;`"),
        );
    }
    check_one(written.sticks(), errors);
    check_one(written.slips(), errors);
}

/// There is one line of this kind.
pub(super) fn check_one<'a>(lines: impl Iterator<Item = &'a Rule>, errors: &mut Errors) {
    for second in lines.skip(1) {
        let word = &second.word;
        errors.at(word, format!("second `{word}` line; keep one"));
    }
}

/// The names that carry a friction force, and those that carry a press, directly or through `let` lines.
pub(super) struct Forces<'a> {
    friction: HashSet<&'a Ident>,
    presses: HashSet<&'a Ident>,
    /// Whether presses enter linearly too.
    straight: bool,
}

/// What a formula carries.
#[derive(Clone, Copy, Default, PartialEq)]
struct Load {
    friction: bool,
    press: bool,
}

impl<'a> Forces<'a> {
    /// Follows the lines from top to bottom; reports every product of forces to `errors`.
    fn of(written: &'a Declaration, straight: bool, errors: &mut Errors) -> Self {
        let mut forces = Self {
            straight,
            friction: HashSet::new(),
            presses: HashSet::new(),
        };
        for line in &written.lines {
            let mut load = Load::default();
            match line {
                Line::Friction(friction) => load.friction = friction.memory.is_empty(),
                Line::Press(_) => load.press = true,
                Line::Let(quantity) => load = forces.enter(&quantity.formula, errors),
                _ => {}
            }
            let name = line.name();
            forces.friction.extend(name.filter(|_| load.friction));
            forces.presses.extend(name.filter(|_| load.press));
        }
        for derivative in written.derivatives() {
            forces.enter(&derivative.formula, errors);
        }
        forces
    }

    /// Whether a name is or contains a force of any kind.
    pub(super) fn carries(&self, name: &Ident) -> bool {
        self.friction.contains(name) || self.presses.contains(name)
    }

    /// The forces on which a formula depends, on those of friction linearly.
    fn enter(&self, formula: &Formula, errors: &mut Errors) -> Load {
        if let Kind::Name(name) = &formula.kind {
            return Load {
                friction: self.friction.contains(name),
                press: self.presses.contains(name),
            };
        }
        let parts = formula.parts().into_iter();
        let parts: Vec<Load> = parts.map(|part| self.enter(part, errors)).collect();
        let linear = match &formula.kind {
            Kind::Group(_) | Kind::Minus(_) => true,
            Kind::Binary(_, Operator::Add | Operator::Subtract, _) => true,
            Kind::Binary(_, Operator::Multiply, _) => parts.contains(&Load::default()),
            Kind::Binary(_, Operator::Divide, _) => parts[1] == Load::default(),
            _ => false,
        };
        let friction = parts.iter().any(|part| part.friction);
        let press = parts.iter().any(|part| part.press);
        if (friction || (press && self.straight)) && !linear {
            errors.at(formula, format!("`{formula}`: {NONLINEAR}"));
        }
        Load {
            friction: friction && linear,
            press,
        }
    }
}

const NONLINEAR: &str = "friction forces must enter linearly, so that the sticking force can be solved for; \
     here one is multiplied by a force, stands in a denominator or inside a function";

/// Friction forces enter the equations linearly: what carries them, and what carries a press.
pub(super) fn check_forces_linear<'a>(written: &'a Declaration, errors: &mut Errors) -> Forces<'a> {
    Forces::of(written, false, errors)
}

/// Whether a press enters the equations otherwise than linearly.
pub(super) fn bends(written: &Declaration) -> bool {
    let mut errors = Errors::new();
    Forces::of(written, true, &mut errors);
    let bends = !errors.is_empty();
    errors.forget();
    bends
}

/// The speed of a contact and the fields of its law depend on no friction force.
pub(super) fn check_laws_read_no_force(
    written: &Declaration,
    forces: &Forces,
    errors: &mut Errors,
) {
    for friction in written.frictions() {
        let own = &friction.name;
        for name in friction.formulas().flat_map(Formula::names) {
            if name != own && forces.friction.contains(name) {
                errors.at(name, format!(
                    "`{name}` is or contains a friction force, and the law and speed of `{own}` cannot depend on one: \
                     a normal force is a formula of states and parameters, or a `press`"
                ));
            }
        }
        for name in friction.speed.names() {
            if forces.presses.contains(name) {
                errors.at(
                    name,
                    format!("`{name}` is or contains a press, and the speed of `{own}` cannot depend on one"),
                );
            }
        }
    }
}
