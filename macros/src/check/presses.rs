//! Presses: how fast their gaps open, and what may stand in them.

use proc_macro2::Ident;

use super::equations::Forces;
use super::names::Names;
use super::resolve::meanings;
use super::slope::{product, slope, sum};
use crate::errors::Errors;
use crate::formula::Formula;
use crate::syntax::{Declaration, Friction};

/// The rate of the gap of a press, by the chain rule; `None` if it reads no state that has an equation.
pub(super) fn rate_of_gap(press: &Friction, written: &Declaration) -> Option<Formula> {
    let meanings = meanings(written);
    let gap = press.speed.unabbreviated(&meanings);
    let moving = |name: &Ident, rate: &Formula| {
        let rate = rate.unabbreviated(&meanings);
        Some(product(slope(&gap, name)?, grouped(rate)))
    };
    let equations = written.derivatives().chain(written.drives());
    equations.fold(None, |total, line| {
        sum(total, moving(&line.name, &line.formula))
    })
}

/// A sum in a product keeps its parentheses where it is shown.
fn grouped(formula: Formula) -> Formula {
    let source = formula.source.clone();
    let kind = crate::formula::Kind::Group(Box::new(formula));
    Formula { kind, source }
}

/// The law and the gap of a press depend on no force.
pub(super) fn check_presses_read_no_force(
    written: &Declaration,
    forces: &Forces,
    errors: &mut Errors,
) {
    for press in written.presses() {
        for name in press.formulas().flat_map(Formula::names) {
            if *name != press.name && forces.carries(name) {
                let own = &press.name;
                errors.at(
                    name,
                    format!(
                        "`{name}` is or contains a force, and the law and gap of `{own}` cannot depend on one: \
                         a gap is a formula of positions, and of the phase of a drive"
                    ),
                );
            }
        }
    }
}

/// A gap opens and closes, and no force acts on the rate at which it does.
pub(super) fn check_gaps_move(
    written: &Declaration,
    names: &Names,
    forces: &Forces,
    errors: &mut Errors,
) {
    for press in written.presses() {
        let (own, gap) = (&press.name, &press.speed);
        let known = gap.names().iter().all(|name| names.noun_of(name).is_some());
        if !known || written.broken().next().is_some() {
            continue;
        }
        let carried = written.frictions().flat_map(|friction| &friction.memory);
        let unabbreviated = gap.unabbreviated(&meanings(written));
        let read = unabbreviated.names();
        if let Some(state) = carried.into_iter().find(|state| read.contains(state)) {
            errors.at(
                gap,
                format!(
                    "the gap of `{own}` reads `{state}`, whose rate a law of friction says: a gap is a formula of positions"
                ),
            );
            continue;
        }
        let Some(rate) = rate_of_gap(press, written) else {
            errors.at(
                gap,
                format!("the gap of `{own}` reads no state: it would never open or close"),
            );
            continue;
        };
        if let Some(force) = rate.names().into_iter().find(|name| forces.carries(name)) {
            errors.at(
                gap,
                format!(
                    "the gap of `{own}` opens at a rate that depends on the force `{force}`: a gap is a formula of positions, \
                     whose equations are velocities, as in `der(x) = v;`"
                ),
            );
        }
    }
}
