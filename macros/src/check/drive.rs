//! The drive: one phase, advancing at a rate of its own, in periodic functions only.

use proc_macro2::Ident;

use super::names::Names;
use crate::arithmetic;
use crate::errors::Errors;
use crate::formula::{Formula, Kind, Operator};
use crate::syntax::Declaration;

/// A model has one drive at most: with two, periods are in general no multiples of either.
pub(super) fn check_one_drive(written: &Declaration, errors: &mut Errors) {
    let first = written.drives().next().map(|drive| &drive.name);
    for second in written.drives().skip(1) {
        let (name, first) = (&second.name, first.unwrap_or(&second.name));
        errors.at(
            name,
            format!(
                "second drive; motions under two of them have no common period unless one is a multiple of the other: \
                 write that one as `cos(2 * {first})`"
            ),
        );
    }
}

/// The rate of a drive is a formula of parameters.
pub(super) fn check_rate(written: &Declaration, names: &Names, errors: &mut Errors) {
    for drive in written.drives() {
        for name in drive.formula.names() {
            if let Some(noun) = names.noun_of(name)
                && names.word_of(name) != Some("param")
            {
                let phase = &drive.name;
                errors.at(
                    name,
                    format!(
                        "`{name}` is a {noun}, and the rate of `{phase}` is a formula of parameters only"
                    ),
                );
            }
        }
    }
}

/// A phase stands in `cos` and `sin` only, times whole numbers: 2π more of it is the same.
pub(super) fn check_periodic(written: &Declaration, errors: &mut Errors) {
    let phases: Vec<&Ident> = written.drives().map(|drive| &drive.name).collect();
    for line in &written.lines {
        for formula in line.formulas() {
            inspect(formula, &phases, errors);
        }
    }
}

fn inspect(formula: &Formula, phases: &[&Ident], errors: &mut Errors) {
    if let Kind::Name(name) = &formula.kind
        && phases.contains(&name)
    {
        errors.at(name, aperiodic(name));
        return;
    }
    let Kind::Call(function, argument) = &formula.kind else {
        for part in formula.parts() {
            inspect(part, phases, errors);
        }
        return;
    };
    let periodic = function == "cos" || function == "sin";
    let mut turns = phases.iter().map(|phase| turns(argument, phase));
    let whole = turns.all(|turns| turns.and_then(arithmetic::whole).is_some());
    if periodic && whole {
        return;
    }
    inspect(argument, phases, errors);
}

fn aperiodic(name: &Ident) -> String {
    format!(
        "the phase `{name}` may stand only inside `cos` and `sin`, times a whole number, as in `cos({name})` or \
         `sin(2 * {name} + lag)`: the force must be the same when it has turned by 2 pi"
    )
}

/// How often an argument turns while the phase turns once, if it is so many times the phase and something else.
pub(crate) fn turns(formula: &Formula, phase: &Ident) -> Option<f64> {
    match &formula.kind {
        Kind::Name(name) if name == phase => Some(1.0),
        Kind::Group(inner) => turns(inner, phase),
        Kind::Minus(inner) => turns(inner, phase).map(|turns| -turns),
        Kind::Binary(x, Operator::Add, y) => Some(turns(x, phase)? + turns(y, phase)?),
        Kind::Binary(x, Operator::Subtract, y) => Some(turns(x, phase)? - turns(y, phase)?),
        Kind::Binary(x, Operator::Multiply, y) => {
            let (left, right) = (turns(x, phase)?, turns(y, phase)?);
            match (x.literal(), y.literal()) {
                _ if left == 0.0 && right == 0.0 => Some(0.0),
                (Some(factor), _) => Some(factor * right),
                (_, Some(factor)) => Some(left * factor),
                _ => None,
            }
        }
        _ => (!formula.names().contains(&phase)).then_some(0.0),
    }
}
