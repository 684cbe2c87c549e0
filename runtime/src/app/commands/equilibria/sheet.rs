//! Equilibria as CSV.

use crate::app::spreadsheet::{Row, full, head as words, optional};
use crate::app::text::{followed, states, timed};
use crate::model::ModelInfo;
use crate::study::{Along, EquilibriumRecord};

/// The columns; the first is what is followed, if anything is.
pub(super) fn head(info: &ModelInfo, along: Option<&Along>) -> Row {
    let along = along.map(|along| followed(info, along));
    let mut head: Row = along.into_iter().chain(states(info, "")).collect();
    for i in 1..=info.states.len() {
        let part = |part| timed(info, &format!("eigenvalue_{i}_{part}"), "1/s");
        head.extend(["re", "im"].map(part));
    }
    head.extend(words(["stability", "mode", "artefact"]));
    head
}

pub(super) fn row(one: &EquilibriumRecord) -> Row {
    let mut row: Row = one.r.iter().chain(&one.state).map(full).collect();
    for i in 0..one.state.len() {
        let value = one.eigenvalues.get(i);
        row.extend([value.map(|value| value.re), value.map(|value| value.im)].map(optional));
    }
    row.push(one.stability.name().to_owned());
    row.push(one.mode.clone().unwrap_or_default());
    row.push(one.artefact.to_string());
    row
}
