//! Laws with internal state: what carries it in a model, and what its formulas may do.

use std::collections::HashMap;

use proc_macro2::Ident;

use super::equations::{check_a_state_named, check_one, state_names};
use super::known::{Force, Law};
use super::names::Names;
use crate::arithmetic::{CORNERS, apply};
use crate::errors::Errors;
use crate::formula::{Formula, Kind, Operator};
use crate::syntax::Declaration;

/// What stands after `with` is a state of the model.
pub(super) fn check_carriers(written: &Declaration, names: &Names, errors: &mut Errors) {
    let states = state_names(written);
    for name in misnamed(written) {
        let only = "and only a state can carry the internal state of a law";
        check_a_state_named(name, names, &states, only, errors);
    }
}

/// What stands after `with` and is no state, not even one whose line is broken.
pub(super) fn misnamed(written: &Declaration) -> impl Iterator<Item = &Ident> {
    let meant = |name: &Ident| {
        let doubtful = written.broken().filter(|line| line.keyword.is_none());
        let doubtful = doubtful.filter_map(|line| line.name.as_ref());
        written
            .named("state")
            .chain(doubtful)
            .any(|state| state == name)
    };
    let named = written.frictions().flat_map(|friction| &friction.memory);
    named.filter(move |name| !meant(name))
}

/// A state carries the internal state of one law.
pub(super) fn check_carried_once(written: &Declaration, errors: &mut Errors) {
    let mut taken: HashMap<&Ident, &Ident> = HashMap::new();
    for friction in written.frictions() {
        for name in &friction.memory {
            if let Some(owner) = taken.insert(name, &friction.name) {
                errors.at(
                    name,
                    format!(
                        "`{name}` already carries an internal state of `{owner}`; declare another state for this one"
                    ),
                );
            }
        }
    }
}

/// The law moves what carries its internal state, and no equation of the model does.
pub(super) fn check_carriers_move_alone(written: &Declaration, errors: &mut Errors) {
    for derivative in written.derivatives() {
        let name = &derivative.name;
        if let Some(owner) = written
            .frictions()
            .find(|friction| friction.memory.contains(name))
        {
            let owner = &owner.name;
            errors.at(
                name,
                format!(
                    "the law of `{owner}` already moves `{name}`: remove this equation, or `{name}` after `with`"
                ),
            );
        }
    }
}

/// A law with internal state has one force for all speeds.
pub(super) fn check_no_rest(written: &Declaration, errors: &mut Errors) {
    let sticks = written.sticks().map(|line| &line.word);
    let slips = written.slips().map(|line| &line.word);
    for word in sticks.chain(slips) {
        errors.at(
            word,
            format!(
                "`{word}` is for laws without internal state; a law with `state` and `der` has one line `force(w) = ...;` \
                 for every relative speed `w`"
            ),
        );
    }
}

/// A law with internal state has one force.
pub(super) fn check_a_force(written: &Declaration, errors: &mut Errors) {
    let name = &written.header.name;
    if written.forces().next().is_none() && !written.lost("force") {
        errors.at(
            name,
            format!("law `{name}` has internal state but no force: add `force(w) = ...;`"),
        );
    }
    check_one(written.forces(), errors);
}

/// A law of presses has one force, or one rebound.
pub(super) fn check_a_press(written: &Declaration, errors: &mut Errors) {
    let name = &written.header.name;
    let lost = written.lost("force") || written.lost("rebound");
    if written.forces().chain(written.rebounds()).next().is_none() && !lost {
        errors.at(
            name,
            format!(
                "law `{name}` has no force: add `force(d, v) = ...;` at the depth d that grows at the rate v, or, where \
                 nothing gives way, `rebound(v) = ...;` after an approach at the speed v"
            ),
        );
    }
    check_one(written.forces(), errors);
    check_one(written.rebounds(), errors);
    if let (Some(_), Some(rebound)) = (written.forces().next(), written.rebounds().next()) {
        errors.at(
            &rebound.word,
            "`rebound` is for a contact that does not give way, and one with a `force` does; keep one of the two",
        );
    }
}

/// A law with a `force` line has internal state.
pub(super) fn check_internal_state(written: &Declaration, errors: &mut Errors) {
    let lost = written
        .broken()
        .any(|line| matches!(line.keyword, Some("state" | "der") | None));
    if let (Some(force), None) = (written.forces().next(), written.states().next())
        && !lost
    {
        errors.at(
            &force.word,
            "`force` is for laws with internal state, and none is declared: add `state z;` and `der(z) = ...;`, \
             or write `stick = ...;` and `slip(s) = ...;`",
        );
    }
}

/// The sign is taken of the speed or of an internal state: what has a surface of its own.
pub(super) fn check_signs(written: &Declaration, errors: &mut Errors) {
    let speeds = written.forces().map(|force| &force.name);
    let states = written.states().map(|state| &state.name);
    let plain: Vec<&Ident> = speeds.chain(states).collect();
    let formulas = written.lines.iter().flat_map(|line| line.formulas());
    for (_, argument) in formulas.flat_map(|formula| formula.calls_of(&["sign"])) {
        let is_plain = matches!(&argument.bare().kind, Kind::Name(name) if plain.contains(&name));
        if !is_plain {
            errors.at(
                argument,
                format!(
                    "`sign` is taken of the relative speed or of an internal state alone, not of `{argument}`; \
                     `abs` takes any formula"
                ),
            );
        }
    }
}

/// Only the formulas of a law with internal state may have kinks.
pub(super) fn check_kinks_have_memory(written: &Declaration, errors: &mut Errors) {
    let formulas = written.lets().map(|line| &line.formula);
    for (function, _) in formulas.flat_map(|formula| formula.calls_of(&CORNERS)) {
        errors.at(
            function,
            format!(
                "`{function}` is not smooth; a law needs neither magnitude nor sign: \
                 the sliding speed is positive, and the force opposes it"
            ),
        );
    }
}

/// Where a sign changes, the formulas do not jump: a force that jumps is dry friction, which `stick` and `slip` describe.
pub(super) fn check_continuous(law: &Law, errors: &mut Errors) {
    let Force::Memory(force) = &law.force else {
        return;
    };
    let rates = law.states.iter();
    let rates = rates.map(|state| (format!("der({})", state.line.name), &state.rate));
    for (line, formula) in rates.chain([(format!("force({})", law.speed), force)]) {
        if let Some(name) = jump(law, &formula.formula) {
            errors.at(
                formula.written,
                format!(
                    "`{line}` jumps where `{name}` changes its sign: `sign({name})` must be multiplied by something \
                     that vanishes there; a force that jumps is described by `stick` and `slip`"
                ),
            );
        }
    }
}

/// So near to zero that any root of it is small.
const NEXT_TO: f64 = 1e-200;

/// The name at whose zero a formula jumps, tried with numbers that mean nothing.
fn jump<'a>(law: &Law<'_>, formula: &'a Formula) -> Option<&'a Ident> {
    let signs = formula.calls_of(&["sign"]).into_iter();
    signs
        .filter_map(|(_, argument)| match &argument.bare().kind {
            Kind::Name(name) => Some(name),
            _ => None,
        })
        .find(|name| {
            (1..=3).any(|trial| {
                let side = |zero: f64| {
                    let value = |other: &Ident| {
                        if other == *name {
                            zero
                        } else {
                            generic(law, other, trial)
                        }
                    };
                    evaluate(formula, &value)
                };
                let (before, after) = (side(-NEXT_TO), side(NEXT_TO));
                let size = side(-0.7).abs() + side(0.7).abs();
                (after - before).abs() > 1e-9 * size
            })
        })
}

/// A number between 0.2 and 1 for each name, its place among all of them, and each trial.
fn generic(law: &Law, name: &Ident, trial: u32) -> f64 {
    let parameters = law.parameters.iter();
    let parameters = parameters.map(|parameter| &parameter.line.name);
    let states = law.states.iter().map(|state| &state.line.name);
    let mut names = parameters.chain(states);
    let place = names.position(|known| known == name).unwrap_or(97);
    let seed = 0.618_033_988_749_895 * (place + 1) as f64 + 0.377 * f64::from(trial);
    0.2 + 0.8 * seed.fract()
}

fn evaluate(formula: &Formula, value: &dyn Fn(&Ident) -> f64) -> f64 {
    let of = |part: &Formula| evaluate(part, value);
    match &formula.kind {
        Kind::Number(number) => number.value,
        Kind::Constant(_) => 1.7,
        Kind::Name(name) => value(name),
        Kind::Group(x) => of(x),
        Kind::Minus(x) => -of(x),
        Kind::Binary(x, operator, y) => match operator {
            Operator::Add => of(x) + of(y),
            Operator::Subtract => of(x) - of(y),
            Operator::Multiply => of(x) * of(y),
            Operator::Divide => of(x) / of(y),
        },
        Kind::Power(x, exponent) => of(x).powi(*exponent),
        Kind::RealPower(_, x, y) => of(x).powf(of(y)),
        Kind::Call(function, x) => apply(function, of(x)),
    }
}
