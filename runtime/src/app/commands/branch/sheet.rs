//! Orbits as CSV.

use crate::app::harmonics;
use crate::app::spreadsheet::{Row, Spreadsheet, full, head as words, optional};
use crate::app::text::{followed, states, timed};
use crate::model::ModelInfo;
use crate::study::{Along, BranchRecord, OrbitRecord};

/// The tables of a branch and of those that leave it: `branch`, `branch-1`, ...
pub(super) fn sheets(
    info: &ModelInfo,
    branch: &BranchRecord,
    orders: &[usize],
) -> Vec<(String, Spreadsheet)> {
    let all = branch.all().into_iter().enumerate();
    let sheet = |(number, one): (usize, &BranchRecord)| {
        let name = match number {
            0 => "branch".to_owned(),
            _ => format!("branch-{number}"),
        };
        let rows = one.points.iter().map(|orbit| row(orbit, info, orders));
        (
            name,
            Spreadsheet::new(head(info, &branch.along, orders), rows),
        )
    };
    all.map(sheet).collect()
}

pub(super) fn head(info: &ModelInfo, along: &Along, orders: &[usize]) -> Row {
    let mut head = vec![followed(info, along), timed(info, "period", "s")];
    head.extend(words(["stability", "period_count"]));
    for prefix in ["", "max_", "min_", "max_abs_"] {
        head.extend(states(info, prefix));
    }
    for i in 1..info.states.len() {
        head.extend(["re", "im", "log_abs"].map(|part| format!("multiplier_{i}_{part}")));
    }
    head.extend(words(["residual", "error_estimate"]));
    head.extend(harmonics::head(info, orders));
    head
}

pub(super) fn row(orbit: &OrbitRecord, info: &ModelInfo, orders: &[usize]) -> Row {
    let floquet = &orbit.floquet;
    let mut row = vec![
        optional(orbit.r),
        full(&orbit.period),
        floquet.stability.name().to_owned(),
        orbit.period_count.to_string(),
    ];
    for states in [&orbit.state, &orbit.max, &orbit.min, &orbit.max_abs] {
        row.extend(states.iter().map(full));
    }
    // One place for each multiplier, even if the eigenvalues could not be found.
    for i in 1..orbit.state.len() {
        let multiplier = floquet.multipliers.get(i - 1);
        let log = floquet.log_moduli.get(i - 1).copied().flatten();
        row.extend([multiplier.map(|m| m.re), multiplier.map(|m| m.im), log].map(optional));
    }
    row.extend([full(&orbit.residual), full(&orbit.error_estimate)]);
    row.extend(harmonics::row(orbit, info.drive, orders));
    row
}
