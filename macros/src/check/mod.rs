//! From a declaration as written to one that is known to be good.

mod arrays;
mod bounds;
mod contacts;
mod dimension;
mod drive;
mod equations;
mod known;
mod memory;
mod names;
mod presses;
mod reserved;
mod resolve;
mod slope;
mod stops;
mod units;

pub(crate) use self::bounds::describe;
pub(crate) use self::dimension::Dimension;
pub(crate) use self::drive::turns;
pub(crate) use self::known::{
    Contact, Force, Law, LawState, Let, Model, Parameter, State, Step, Unit, Whole,
};
use self::names::Names;
pub(crate) use self::reserved::is_field;
use self::units::Units;
use crate::errors::Errors;
use crate::parse::Grammar;
use crate::syntax::Declaration;

/// Asks everything that a model must answer.
pub(crate) fn model<'a>(written: &'a Declaration, errors: &mut Errors) -> Option<Model<'a>> {
    let legible = errors.is_empty();
    let names = Names::of(written, Grammar::Model);
    reserved::check_reserved(written, &names, errors);
    names::check_declared_once(&names, errors);
    arrays::check_counters(written, &names, errors);
    arrays::check_indices(written, &names, errors);
    names::check_known(written, &names, errors);
    names::check_declared_above(written, errors);
    equations::check_a_state(written, errors);
    equations::check_left_sides(written, &names, errors);
    equations::check_one_equation_each(written, errors);
    memory::check_carriers(written, &names, errors);
    memory::check_carried_once(written, errors);
    memory::check_carriers_move_alone(written, errors);
    drive::check_one_drive(written, errors);
    drive::check_rate(written, &names, errors);
    drive::check_periodic(written, errors);
    let forces = equations::check_forces_linear(written, errors);
    equations::check_laws_read_no_force(written, &forces, errors);
    presses::check_presses_read_no_force(written, &forces, errors);
    presses::check_gaps_move(written, &names, &forces, errors);
    bounds::check_bounds(written, errors);
    let units = Units::of(written, errors);
    units::check_drive(written, &units, errors);
    contacts::check_contacts(written, &units, errors);
    units::check_equations(written, &units, errors);
    units::check_loads(written, &units, errors);
    if legible {
        names::check_used(written, &names, errors);
    }
    if errors.is_empty() {
        resolve::model(written, &units)
    } else {
        None
    }
}

/// Asks everything that a law of this grammar must answer.
pub(crate) fn law<'a>(
    written: &'a Declaration,
    grammar: Grammar,
    errors: &mut Errors,
) -> Option<Law<'a>> {
    let legible = errors.is_empty();
    let names = Names::of(written, grammar);
    reserved::check_reserved(written, &names, errors);
    names::check_declared_once(&names, errors);
    names::check_known(written, &names, errors);
    names::check_declared_above(written, errors);
    if grammar != Grammar::Press && written.has_memory() {
        memory::check_no_rest(written, errors);
        memory::check_a_force(written, errors);
        memory::check_internal_state(written, errors);
        equations::check_left_sides(written, &names, errors);
        equations::check_one_equation_each(written, errors);
        memory::check_signs(written, errors);
        stops::check_stopped_states(written, &names, errors);
        stops::check_one_stop_each(written, errors);
        stops::check_stops_stand_still(written, errors);
    } else if grammar == Grammar::Press {
        memory::check_a_press(written, errors);
    } else {
        names::check_rest_has_no_speed(written, errors);
        equations::check_stick_and_slip(written, errors);
        memory::check_kinks_have_memory(written, errors);
    }
    bounds::check_bounds(written, errors);
    let units = Units::of(written, errors);
    units::check_law(written, &units, errors);
    units::check_equations(written, &units, errors);
    stops::check_units(written, &units, errors);
    if legible {
        names::check_used(written, &names, errors);
    }
    let law = errors
        .is_empty()
        .then(|| resolve::law(written, &units))
        .flatten()?;
    memory::check_continuous(&law, errors);
    errors.is_empty().then_some(law)
}

/// Takes over a model of which nothing is asked.
pub(crate) fn unasked_model(written: &Declaration) -> Option<Model<'_>> {
    resolve::model(written, &Units::default())
}

/// Takes over a law of which nothing is asked.
pub(crate) fn unasked_law(written: &Declaration) -> Option<Law<'_>> {
    resolve::law(written, &Units::default())
}
