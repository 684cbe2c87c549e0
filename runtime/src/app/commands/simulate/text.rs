//! A motion as text.

use crate::app::text::{heading, label, line, number, short, table, time_unit, work};
use crate::model::ModelInfo;
use crate::study::{Case, Trajectory};

/// Digits shown of a state.
const DIGITS: usize = 8;

pub(super) fn describe(info: &ModelInfo, case: &Case, motion: &Trajectory, time: f64) -> String {
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
