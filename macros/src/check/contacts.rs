//! What contacts act against: friction against a speed, a press against a displacement.

use proc_macro2::Ident;

use super::dimension::Dimension;
use super::resolve::meanings;
use super::units::Units;
use crate::errors::Errors;
use crate::formula::{Formula, Kind};
use crate::syntax::{Declaration, Friction, Rule};

/// The fields of a contact agree in themselves; friction opposes no displacement, by its unit or by its equation, and a
/// press closes no speed.
pub(super) fn check_contacts(written: &Declaration, units: &Units, errors: &mut Errors) {
    for contact in written.frictions().chain(written.presses()) {
        for field in &contact.fields {
            units.measure(&field.formula, errors);
        }
    }
    for friction in written.frictions() {
        check_friction(written, units, friction, errors);
    }
    for press in written.presses() {
        let (name, gap) = (&press.name, &press.speed);
        if units.measure(gap, errors) == Some(Dimension::SPEED) {
            let message = format!(
                "a press closes a gap, but `{gap}` is a speed, in m/s: write the distance at the contact of `{name}`; its \
                 law knows how fast that closes"
            );
            errors.at(gap, message);
        }
    }
}

fn check_friction(written: &Declaration, units: &Units, friction: &Friction, errors: &mut Errors) {
    let (name, speed) = (&friction.name, &friction.speed);
    let known = errors.len();
    if rests(written, friction) {
        let message = format!(
            "friction opposes a speed, but `{speed}` reads no state, so that the contact of `{name}` would never start or stop \
             sliding: write its relative speed, such as `opposing v - v_belt`"
        );
        errors.at(speed, message);
        return;
    }
    let by_unit = units.measure(speed, errors) == Some(Dimension::LENGTH);
    if errors.len() > known {
        return;
    }
    let moved = displaced(written, friction);
    let why = match &moved {
        _ if by_unit => "in m".to_owned(),
        Some((state, rate)) => format!("for `der({state}) = {rate}`, on which `{name}` acts"),
        None => return,
    };
    let instead = moved.map_or_else(|| "v".to_owned(), |(_, rate)| rate);
    let message = format!(
        "friction opposes a speed, but `{speed}` is a displacement, {why}: write the relative speed of the contact, such as \
         `opposing {instead}`"
    );
    errors.at(speed, message);
}

/// Whether what a friction opposes never changes, as far as all of it is known.
fn rests(written: &Declaration, friction: &Friction) -> bool {
    let speed = friction.speed.unabbreviated(&meanings(written));
    let moves = |name: &Ident| {
        let fixed = written.params().any(|param| param.name == *name);
        !fixed && name != &friction.name
    };
    written.broken().next().is_none() && !speed.names().into_iter().any(moves)
}

/// A state that friction opposes, and its rate, if the rate of each that it opposes is another state on which the same
/// friction acts.
fn displaced<'a>(written: &'a Declaration, friction: &'a Friction) -> Option<(&'a Ident, String)> {
    let equation = |state: &Ident| written.derivatives().find(|line| line.name == *state);
    let single = |formula: &'a Formula| match &formula.kind {
        Kind::Name(name) => Some(name),
        _ => None,
    };
    let acts = |Rule { formula, .. }: &Rule| formula.names().contains(&&friction.name);
    let rate = |state: &Ident| {
        let rate = equation(state).and_then(|line| single(&line.formula))?;
        equation(rate).is_some_and(acts).then_some(rate)
    };
    let names = friction.speed.names().into_iter();
    let states: Vec<&Ident> = names.filter(|name| equation(name).is_some()).collect();
    let rates: Option<Vec<&Ident>> = states.iter().map(|state| rate(state)).collect();
    let (state, rate) = (states.first()?, *rates?.first()?);
    Some((state, rate.to_string()))
}
