//! A diagram as CSV.

use crate::app::spreadsheet::{Columns, Row, Spreadsheet, headed};
use crate::app::text::{followed, states, timed};
use crate::lyapunov::Lyapunov;
use crate::model::ModelInfo;
use crate::study::{Along, DiagramRecord, Slice};

/// The columns of the points at the value `r` of what is followed.
pub(super) fn points<'a>(
    info: &ModelInfo,
    along: &Along,
    sweep: &'a str,
    r: f64,
) -> Columns<'a, Vec<f64>> {
    Columns::new()
        .column("sweep", move |_: &Vec<f64>| sweep.to_owned())
        .number(followed(info, along), move |_| r)
        .numbers(states(info, ""), |point, j| point.get(j).copied())
}

/// The columns of the values of a sweep.
pub(super) fn values<'a>(info: &ModelInfo, along: &Along, sweep: &'a str) -> Columns<'a, Slice> {
    let error = |slice: &Slice| {
        let error = exponent(slice).and(found(slice))?.error;
        error.is_finite().then_some(error)
    };
    Columns::new()
        .column("sweep", move |_: &Slice| sweep.to_owned())
        .number(followed(info, along), |slice| slice.r)
        .column("motion", |slice| slice.motion.name())
        .number(timed(info, "lyapunov", "1/s"), exponent)
        .number(timed(info, "lyapunov_error", "1/s"), error)
        .numbers(states(info, "min_"), |slice, j| slice.min.get(j).copied())
        .numbers(states(info, "max_"), |slice, j| slice.max.get(j).copied())
}

/// The largest Lyapunov exponent of a value, where it has one.
pub(super) fn exponent(slice: &Slice) -> Option<f64> {
    found(slice)?.exponent
}

fn found(slice: &Slice) -> Option<&Lyapunov> {
    slice.lyapunov.as_ref()?.as_ref().ok()
}

/// One row for each point of a value.
pub(super) fn rows(info: &ModelInfo, along: &Along, sweep: &str, slice: &Slice) -> Vec<Row> {
    let columns = points(info, along, sweep, slice.r);
    slice
        .points
        .iter()
        .map(|point| columns.row(point))
        .collect()
}

/// All points, and all values.
pub(super) fn sheets(info: &ModelInfo, record: &DiagramRecord) -> [Spreadsheet; 2] {
    let (along, sweeps) = (&record.along, || record.sweeps.iter());
    let points = sweeps().flat_map(|sweep| {
        let slices = sweep.slices.iter();
        slices.flat_map(|slice| rows(info, along, sweep.name, slice))
    });
    let values = sweeps().flat_map(|sweep| {
        let columns = values(info, along, sweep.name);
        let slices = sweep.slices.iter();
        slices.map(move |slice| columns.row(slice))
    });
    [
        headed(self::points(info, along, "", 0.0).head(), points),
        headed(self::values(info, along, "").head(), values),
    ]
}
