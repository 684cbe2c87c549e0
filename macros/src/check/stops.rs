//! Stops: how far an internal state of a law may go.

use proc_macro2::Ident;

use super::equations::{not_a_state, state_names};
use super::names::{Names, made_of};
use super::units::Units;
use crate::errors::Errors;
use crate::syntax::{Declaration, Stop};

/// What stops is a state of the law.
pub(super) fn check_stopped_states(written: &Declaration, names: &Names, errors: &mut Errors) {
    let states = state_names(written);
    for stop in written.stops() {
        let name = stop.state.to_string();
        if !states.contains(&name) {
            let advice = not_a_state(&stop.state, names, &states, "stop");
            errors.at(&stop.state, format!("`{name}` is {advice}"));
        }
    }
}

/// A state stops at one magnitude.
pub(super) fn check_one_stop_each(written: &Declaration, errors: &mut Errors) {
    for (i, stop) in written.stops().enumerate() {
        if written.stops().take(i).any(|one| one.state == stop.state) {
            let name = &stop.state;
            errors.at(
                name,
                format!("second stop of `{name}`; keep one: it stands on both sides of zero"),
            );
        }
    }
}

/// A stop is where the parameters put it, and stays there while the system moves.
pub(super) fn check_stops_stand_still(written: &Declaration, errors: &mut Errors) {
    let speeds = written.forces().map(|force| &force.speed);
    let states = written.states().map(|state| &state.name);
    let moving: Vec<&Ident> = made_of(written, speeds.chain(states).collect());
    for stop in written.stops() {
        for name in stop.bound.names() {
            if moving.contains(&name) {
                let state = &stop.state;
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
    let of_state = |stop: &&Stop| written.states().any(|state| state.name == stop.state);
    for stop in written.stops().filter(of_state) {
        let found = units.measure(&stop.bound, errors);
        if let (Some(wanted), Some(found)) = (units.of_name(&stop.state), found)
            && wanted != found
        {
            let (state, bound) = (&stop.state, &stop.bound);
            errors.at(
                bound,
                format!("unit mismatch: `{state}` is in {wanted}, but it is to stop at `{bound}`, which is in {found}"),
            );
        }
    }
}
