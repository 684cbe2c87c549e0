//! A motion as JSON.

use crate::app::document::{Document, columns, named};
use crate::model::ModelInfo;
use crate::study::{Case, Trajectory};

/// A motion, each quantity as one column.
pub(super) fn document<'a>(info: &'a ModelInfo, case: &Case, motion: &Trajectory) -> Document<'a> {
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
