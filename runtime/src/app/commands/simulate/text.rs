//! A motion as text.

use crate::app::text::{label, number, parameters, short, table, time_unit, work};
use crate::model::ModelInfo;
use crate::study::{Case, Trajectory};

/// Digits shown of a state.
const DIGITS: usize = 8;

pub(super) fn describe(info: &ModelInfo, case: &Case, motion: &Trajectory, time: f64) -> String {
    let duration = short(time) + time_unit(info);
    [
        format!(
            "{}, {}: a motion of {duration}\n",
            info.command, case.dynamics
        ),
        format!("  {}\n\n", parameters(info, case)),
        table(&states(info, motion)),
        table(&others(info, motion)),
        format!(
            "\n  {} samples; {}\n",
            motion.times.len(),
            work(&motion.work)
        ),
    ]
    .concat()
}

fn states(info: &ModelInfo, motion: &Trajectory) -> Vec<Vec<String>> {
    let mut rows = vec![
        ["state", "start", "end", "min", "max"]
            .map(str::to_owned)
            .to_vec(),
    ];
    let (start, end) = (motion.states.first(), motion.states.last());
    for (j, state) in info.states.iter().enumerate() {
        let columns = [start, end, Some(&motion.min), Some(&motion.max)];
        let mut row = vec![label(state.name, state.unit)];
        row.extend(columns.map(|column| show(column.and_then(|values| values.get(j)))));
        rows.push(row);
    }
    rows
}

/// Observables and forces at both ends.
fn others(info: &ModelInfo, motion: &Trajectory) -> Vec<Vec<String>> {
    let mut rows = Vec::new();
    let mut add = |name: String, values: &[Vec<f64>], j: usize| {
        let ends = [values.first(), values.last()];
        let mut row = vec![name];
        row.extend(ends.map(|values| show(values.and_then(|values| values.get(j)))));
        rows.push(row);
    };
    for (j, line) in info.observables.iter().enumerate() {
        add(label(line.name, line.unit), &motion.observables, j);
    }
    for (j, contact) in info.contacts.iter().enumerate() {
        add(label(contact.name, contact.unit), &motion.forces, j);
    }
    if !rows.is_empty() {
        rows.insert(0, ["quantity", "start", "end"].map(str::to_owned).to_vec());
    }
    rows
}

fn show(value: Option<&f64>) -> String {
    value.map_or(String::new(), |&value| number(value, DIGITS))
}
