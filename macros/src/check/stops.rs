//! Stops: how far an internal state of a law may go.

use proc_macro2::Ident;

use super::equations::{check_a_state_named, state_names};
use super::names::{Names, made_of};
use super::units::Units;
use crate::errors::Errors;
use crate::syntax::{Declaration, Rule};

/// What stops is a state of the law.
pub(super) fn check_stopped_states(written: &Declaration, names: &Names, errors: &mut Errors) {
    let states = state_names(written);
    for stop in written.stops() {
        let only = "not a state; only states stop";
        check_a_state_named(&stop.name, names, &states, only, errors);
    }
}

/// A state stops at one magnitude.
pub(super) fn check_one_stop_each(written: &Declaration, errors: &mut Errors) {
    for (i, stop) in written.stops().enumerate() {
        let name = &stop.name;
        if written.stops().take(i).any(|one| one.name == *name) {
            errors.at(
                name,
                format!("second stop of `{name}`; keep one: it stands on both sides of zero"),
            );
        }
    }
}

/// A stop is where the parameters put it, and stays there while the system moves.
pub(super) fn check_stops_stand_still(written: &Declaration, errors: &mut Errors) {
    let speeds = written.forces().map(|force| &force.name);
    let states = written.states().map(|state| &state.name);
    let moving: Vec<&Ident> = made_of(written, speeds.chain(states).collect());
    for stop in written.stops() {
        for name in stop.formula.names() {
            if moving.contains(&name) {
                let state = &stop.name;
                errors.at(
                    name,
                    format!(
                        "`{name}` changes along a motion, and the stops of `{state}` stand still: \
                         write a formula of the parameters, as in `stop {state} at limit;`"
                    ),
                );
            }
        }
    }
}

/// A stop is in the unit of what it stops.
pub(super) fn check_units(written: &Declaration, units: &Units, errors: &mut Errors) {
    let of_state = |stop: &&Rule| written.states().any(|state| state.name == stop.name);
    for stop in written.stops().filter(of_state) {
        let (state, bound) = (&stop.name, &stop.formula);
        units.demand(bound, units.of_name(state), errors, |wanted, found| {
            format!("`{state}` is in {wanted}, but it is to stop at `{bound}`, which is in {found}")
        });
    }
}
