//! A curve as CSV.

use crate::app::spreadsheet::{Row, full, head as words, optional};
use crate::app::text::{followed, states, timed};
use crate::model::ModelInfo;
use crate::study::{Along, CurvePointRecord};

pub(super) fn head(info: &ModelInfo, ranges: [&Along; 2]) -> Row {
    let mut head = ranges.map(|range| followed(info, range)).to_vec();
    head.push(timed(info, "period", "s"));
    head.extend(states(info, ""));
    for i in 1..info.states.len() {
        head.extend(["re", "im"].map(|part| format!("multiplier_{i}_{part}")));
    }
    head.extend(words(["residual", "test"]));
    head
}

pub(super) fn row(point: &CurvePointRecord) -> Row {
    let values = [point.p, point.q, point.period];
    let mut row: Row = values.iter().chain(&point.state).map(full).collect();
    for i in 1..point.state.len() {
        let multiplier = point.multipliers.get(i - 1);
        row.extend([multiplier.map(|m| m.re), multiplier.map(|m| m.im)].map(optional));
    }
    row.extend([full(&point.residual), full(&point.test)]);
    row
}
