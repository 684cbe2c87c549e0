//! A diagram as CSV.

use crate::app::spreadsheet::{Row, full, head as words, optional};
use crate::app::text::{states, timed};
use crate::model::ModelInfo;
use crate::study::Slice;

/// The columns of points; `name` is what is followed, with its unit.
pub(super) fn points_head(info: &ModelInfo, name: &str) -> Row {
    words(["sweep", name])
        .into_iter()
        .chain(states(info, ""))
        .collect()
}

/// One row for each point of a value.
pub(super) fn points(sweep: &str, slice: &Slice) -> impl Iterator<Item = Row> {
    slice.points.iter().map(move |point| {
        let values = std::iter::once(&slice.r).chain(point).map(full);
        std::iter::once(sweep.to_owned()).chain(values).collect()
    })
}

/// The columns of values; `name` is what is followed, with its unit.
pub(super) fn values_head(info: &ModelInfo, name: &str) -> Row {
    let mut head = words(["sweep", name, "motion"]);
    head.extend(["lyapunov", "lyapunov_error"].map(|name| timed(info, name, "1/s")));
    for prefix in ["min_", "max_"] {
        head.extend(states(info, prefix));
    }
    head
}

/// One row for a value of so many states.
pub(super) fn value(sweep: &str, slice: &Slice, states: usize) -> Row {
    let found = slice
        .lyapunov
        .as_ref()
        .and_then(|found| found.as_ref().ok());
    let exponent = found.and_then(|found| found.exponent);
    let error = exponent.and(found.map(|found| found.error));
    let mut row = vec![
        sweep.to_owned(),
        full(&slice.r),
        slice.motion.name(),
        optional(exponent),
        optional(error.filter(|error| error.is_finite())),
    ];
    for side in [&slice.min, &slice.max] {
        row.extend((0..states).map(|j| optional(side.get(j).copied())));
    }
    row
}
