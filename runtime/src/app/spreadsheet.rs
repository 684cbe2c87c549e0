//! CSV files.

use super::failure::Failure;
use super::text::{label, timed};
use crate::model::ModelInfo;
use crate::poincare::Crossing;
use crate::study::{EquilibriumRecord, OrbitRecord, Trajectory};

/// A table of words and numbers with a head.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::app) struct Spreadsheet {
    rows: Vec<Vec<String>>,
}

impl Spreadsheet {
    /// The table as CSV.
    pub(super) fn text(&self) -> Result<String, Failure> {
        let failed =
            |error: String| Failure::failed(format!("the table cannot be written: {error}"));
        let mut writer = csv::Writer::from_writer(Vec::new());
        for row in &self.rows {
            writer
                .write_record(row)
                .map_err(|error| failed(error.to_string()))?;
        }
        let bytes = writer
            .into_inner()
            .map_err(|error| failed(error.to_string()))?;
        String::from_utf8(bytes).map_err(|error| failed(error.to_string()))
    }

    /// The rows below the head.
    pub(super) fn without_head(mut self) -> Self {
        self.rows.drain(..self.rows.len().min(1));
        self
    }

    /// A table of these rows, the first its head.
    pub(super) fn of(rows: Vec<Vec<String>>) -> Self {
        Self { rows }
    }

    /// A motion, one row for each time.
    pub(super) fn motion(info: &ModelInfo, motion: &Trajectory) -> Self {
        let states = info
            .states
            .iter()
            .map(|state| label(state.name, state.unit));
        let observables = info
            .observables
            .iter()
            .map(|line| label(line.name, line.unit));
        let forces = info
            .contacts
            .iter()
            .map(|contact| label(contact.name, contact.unit));
        let head = std::iter::once(timed(info, "t", "s"))
            .chain(states)
            .chain(observables)
            .chain(forces);
        let mut rows = vec![head.collect::<Vec<_>>()];
        for (i, time) in motion.times.iter().enumerate() {
            let columns = [&motion.states[i], &motion.observables[i], &motion.forces[i]];
            let values = columns.into_iter().flatten();
            rows.push(std::iter::once(time).chain(values).map(full).collect());
        }
        Self { rows }
    }

    /// Points on a section, one row for each.
    pub(super) fn crossings(info: &ModelInfo, points: &[Crossing]) -> Self {
        let states = info.states.iter();
        let names = states.map(|state| label(state.name, state.unit));
        let head = std::iter::once(timed(info, "t", "s"))
            .chain(names)
            .chain(["direction".to_owned()]);
        let row = |point: &Crossing| {
            let values = std::iter::once(&point.time).chain(&point.state);
            let direction = if point.rising { "up" } else { "down" };
            values.map(full).chain([direction.to_owned()]).collect()
        };
        Self {
            rows: std::iter::once(head.collect())
                .chain(points.iter().map(row))
                .collect(),
        }
    }

    /// Orbits, one row for each; `name` is what is followed, with its unit.
    pub(super) fn orbits(info: &ModelInfo, name: &str, orbits: &[OrbitRecord]) -> Self {
        let mut rows = vec![head(info, name)];
        rows.extend(orbits.iter().map(row));
        Self { rows }
    }

    /// Equilibria, one row for each; `name` is what is followed, with its unit, if anything is.
    pub(super) fn equilibria(info: &ModelInfo, name: &str, all: &[EquilibriumRecord]) -> Self {
        let states = info
            .states
            .iter()
            .map(|state| label(state.name, state.unit));
        let mut head: Vec<String> = (!name.is_empty())
            .then(|| name.to_owned())
            .into_iter()
            .collect();
        head.extend(states);
        for i in 1..=info.states.len() {
            let part = |part| timed(info, &format!("eigenvalue_{i}_{part}"), "1/s");
            head.extend(["re", "im"].map(part));
        }
        head.extend(["stability", "mode", "artefact"].map(str::to_owned));
        let row = |one: &EquilibriumRecord| {
            let mut row: Vec<String> = one.r.iter().chain(&one.state).map(full).collect();
            for i in 0..info.states.len() {
                let value = one.eigenvalues.get(i);
                let parts = [value.map(|value| value.re), value.map(|value| value.im)];
                row.extend(parts.map(|part| part.as_ref().map(full).unwrap_or_default()));
            }
            row.push(one.stability.name().to_owned());
            row.push(one.mode.clone().unwrap_or_default());
            row.push(one.artefact.to_string());
            row
        };
        Self {
            rows: std::iter::once(head).chain(all.iter().map(row)).collect(),
        }
    }
}

fn head(info: &ModelInfo, name: &str) -> Vec<String> {
    let period = timed(info, "period", "s");
    let mut head: Vec<String> = [name, &period, "stability", "period_count"]
        .map(str::to_owned)
        .into();
    for prefix in ["", "max_", "min_", "max_abs_"] {
        head.extend(
            info.states
                .iter()
                .map(|state| label(&format!("{prefix}{}", state.name), state.unit)),
        );
    }
    for i in 1..info.states.len() {
        head.extend(["re", "im", "log_abs"].map(|part| format!("multiplier_{i}_{part}")));
    }
    head.extend(["residual", "error_estimate"].map(str::to_owned));
    head
}

fn row(orbit: &OrbitRecord) -> Vec<String> {
    let mut row = vec![
        orbit.r.as_ref().map(full).unwrap_or_default(),
        full(&orbit.period),
        orbit.floquet.stability.name().to_owned(),
        orbit.period_count.to_string(),
    ];
    for states in [&orbit.state, &orbit.max, &orbit.min, &orbit.max_abs] {
        row.extend(states.iter().map(full));
    }
    // One place for each multiplier, even if the eigenvalues could not be found.
    for i in 1..orbit.state.len() {
        let multiplier = orbit.floquet.multipliers.get(i - 1);
        let log = orbit.floquet.log_moduli.get(i - 1).copied().flatten();
        let parts = [multiplier.map(|m| m.re), multiplier.map(|m| m.im), log];
        row.extend(parts.map(|part| part.as_ref().map(full).unwrap_or_default()));
    }
    row.extend([full(&orbit.residual), full(&orbit.error_estimate)]);
    row
}

/// All digits of a number, or nothing.
pub(super) fn optional(value: Option<f64>) -> String {
    value.as_ref().map(full).unwrap_or_default()
}

/// All digits of a number.
pub(in crate::app) fn full(value: &f64) -> String {
    format!("{value:?}")
}
