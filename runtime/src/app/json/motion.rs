//! A motion as JSON.

use super::work::Counts;
use super::{Crossings, Named, parameters, states, units};
use crate::model::ModelInfo;
use crate::study::{Case, Trajectory};

/// A motion, each quantity as one column.
#[derive(serde::Serialize)]
pub(in crate::app) struct Motion<'a> {
    model: &'a str,
    dynamics: String,
    parameters: Named<'a, f64>,
    time: &'a [f64],
    states: Named<'a, Vec<f64>>,
    observables: Named<'a, Vec<f64>>,
    forces: Named<'a, Vec<f64>>,
    state: Named<'a, f64>,
    max: Named<'a, f64>,
    min: Named<'a, f64>,
    units: Named<'a, &'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    section: Option<Crossings<'a>>,
    work: Counts,
}

impl<'a> Motion<'a> {
    pub(in crate::app) fn new(info: &'a ModelInfo, case: &Case, motion: &'a Trajectory) -> Self {
        let observables = info.observables.iter().map(|line| line.name);
        let forces = info.contacts.iter().map(|contact| contact.name);
        let end = motion.states.last().cloned().unwrap_or_default();
        Self {
            model: info.command,
            dynamics: case.dynamics.to_string(),
            parameters: parameters(info, &case.parameters),
            time: &motion.times,
            states: states(info, columns(&motion.states, info.states.len())),
            observables: Named::new(
                observables,
                columns(&motion.observables, info.observables.len()),
            ),
            forces: Named::new(forces, columns(&motion.forces, info.contacts.len())),
            state: states(info, end),
            max: states(info, motion.max.clone()),
            min: states(info, motion.min.clone()),
            units: units(info),
            section: None,
            work: Counts::from(&motion.work),
        }
    }

    /// The same with its points on a section.
    pub(in crate::app) fn with_section(mut self, section: Option<Crossings<'a>>) -> Self {
        self.section = section;
        self
    }
}

fn columns(rows: &[Vec<f64>], count: usize) -> Vec<Vec<f64>> {
    let column = |j: usize| rows.iter().filter_map(|row| row.get(j).copied()).collect();
    (0..count).map(column).collect()
}
