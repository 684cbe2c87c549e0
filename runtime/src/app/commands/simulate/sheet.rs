//! A motion as CSV.

use crate::app::spreadsheet::{Row, Spreadsheet, full, labels};
use crate::app::text::{states, timed};
use crate::model::ModelInfo;
use crate::study::Trajectory;

/// One row for each time.
pub(in crate::app) fn sheet(info: &ModelInfo, motion: &Trajectory) -> Spreadsheet {
    let observables = info.observables.iter().map(|line| (line.name, line.unit));
    let forces = info
        .contacts
        .iter()
        .map(|contact| (contact.name, contact.unit));
    let head = std::iter::once(timed(info, "t", "s"))
        .chain(states(info, ""))
        .chain(labels(observables.chain(forces)));
    let row = |(i, time): (usize, &f64)| {
        let columns = [&motion.states[i], &motion.observables[i], &motion.forces[i]];
        let values = columns.into_iter().flatten();
        std::iter::once(time)
            .chain(values)
            .map(full)
            .collect::<Row>()
    };
    Spreadsheet::new(head.collect(), motion.times.iter().enumerate().map(row))
}
