//! A motion in all forms.

use super::picture::picture;
use crate::app::answer::Answer;
use crate::app::document::{Document, columns, named};
use crate::app::spreadsheet::{Columns, Spreadsheet};
use crate::app::text::{
    heading, label, line, number, short, states as named_states, table, time_unit, timed, work,
};
use crate::model::ModelInfo;
use crate::study::{Case, Trajectory};

/// A motion of this time.
pub(super) fn answer(
    info: &ModelInfo,
    case: &Case,
    motion: &Trajectory,
    time: f64,
) -> Answer<'static> {
    let (text, document) = (
        describe(info, case, motion, time),
        document(info, case, motion),
    );
    let answer = Answer::new("trajectory", text, document);
    drawn("trajectory", answer, info, motion)
}

/// An answer with the table and the picture of a motion, by this name.
pub(in crate::app::commands) fn drawn<'a>(
    name: &str,
    answer: Answer<'a>,
    info: &ModelInfo,
    motion: &Trajectory,
) -> Answer<'a> {
    answer
        .sheet(name, sheet(info, motion))
        .figure(name, picture(info, motion))
}

/// One row for each time.
fn sheet(info: &ModelInfo, motion: &Trajectory) -> Spreadsheet {
    let observables = info.observables.iter();
    let observables = observables.map(|line| label(line.name, line.unit));
    let forces = info
        .contacts
        .iter()
        .map(|contact| label(contact.name, contact.unit));
    let columns = Columns::new()
        .number(timed(info, "t", "s"), |&i: &usize| Some(motion.times[i]))
        .numbers(named_states(info, ""), |&i, j| Some(motion.states[i][j]))
        .numbers(observables, |&i, j| Some(motion.observables[i][j]))
        .numbers(forces, |&i, j| Some(motion.forces[i][j]));
    columns.sheet(&(0..motion.times.len()).collect::<Vec<_>>())
}

/// Digits shown of a state.
const DIGITS: usize = 8;

fn describe(info: &ModelInfo, case: &Case, motion: &Trajectory, time: f64) -> String {
    let what = format!("a motion of {}{}", short(time), time_unit(info));
    let (states, others) = (table(&states(info, motion)), table(&others(info, motion)));
    let (samples, work) = (motion.times.len(), work(&motion.work));
    heading(info, case, &what) + &format!("{states}{others}\n  {samples} samples; {work}\n")
}

fn states(info: &ModelInfo, motion: &Trajectory) -> String {
    let mut lines = "state\tstart\tend\tmin\tmax\n".to_owned();
    let (start, end) = (motion.states.first(), motion.states.last());
    let columns = [start, end, Some(&motion.min), Some(&motion.max)];
    for (j, state) in info.states.iter().enumerate() {
        lines += &row(label(state.name, state.unit), columns, j);
    }
    lines
}

/// Observables and forces at both ends.
fn others(info: &ModelInfo, motion: &Trajectory) -> String {
    let mut lines = String::new();
    for (j, line) in info.observables.iter().enumerate() {
        let ends = [motion.observables.first(), motion.observables.last()];
        lines += &row(label(line.name, line.unit), ends, j);
    }
    for (j, contact) in info.contacts.iter().enumerate() {
        let ends = [motion.forces.first(), motion.forces.last()];
        lines += &row(label(contact.name, contact.unit), ends, j);
    }
    if !lines.is_empty() {
        lines.insert_str(0, "quantity\tstart\tend\n");
    }
    lines
}

/// The value number `j` of each column.
fn row<const COUNT: usize>(name: String, columns: [Option<&Vec<f64>>; COUNT], j: usize) -> String {
    let show = |value: Option<&f64>| value.map_or(String::new(), |&value| number(value, DIGITS));
    let cells = columns.map(|column| show(column.and_then(|values| values.get(j))));
    line([name].into_iter().chain(cells))
}

/// A motion, each quantity as one column.
fn document<'a>(info: &'a ModelInfo, case: &Case, motion: &Trajectory) -> Document<'a> {
    let observables = info.observables.iter().map(|line| line.name);
    let forces = info.contacts.iter().map(|contact| contact.name);
    Document::case(info, case)
        .put("time", &motion.times)
        .states("states", columns(&motion.states, info.states.len()))
        .put(
            "observables",
            named(
                observables,
                columns(&motion.observables, info.observables.len()),
            ),
        )
        .put(
            "forces",
            named(forces, columns(&motion.forces, info.contacts.len())),
        )
        .states("state", motion.states.last().into_iter().flatten())
        .states("max", &motion.max)
        .states("min", &motion.min)
        .units()
}
