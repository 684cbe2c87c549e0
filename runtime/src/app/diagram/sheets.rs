//! A diagram as CSV.

use super::super::spreadsheet::{Spreadsheet, full, optional};
use super::super::text::{label, timed};
use crate::model::ModelInfo;
use crate::study::Slice;

/// One row for each point; `name` is what is followed, with its unit.
pub(super) fn points<'a>(
    info: &ModelInfo,
    name: &str,
    slices: impl IntoIterator<Item = (&'a str, &'a Slice)>,
) -> Spreadsheet {
    let mut head = vec!["sweep".to_owned(), name.to_owned()];
    head.extend(
        info.states
            .iter()
            .map(|state| label(state.name, state.unit)),
    );
    let row = |sweep: &str, slice: &Slice, point: &Vec<f64>| {
        let values = std::iter::once(&slice.r).chain(point).map(full);
        std::iter::once(sweep.to_owned()).chain(values).collect()
    };
    let mut rows: Vec<Vec<String>> = vec![head];
    for (sweep, slice) in slices {
        rows.extend(slice.points.iter().map(|point| row(sweep, slice, point)));
    }
    Spreadsheet::of(rows)
}

/// One row for each value; `name` is what is followed, with its unit.
pub(super) fn values<'a>(
    info: &ModelInfo,
    name: &str,
    slices: impl IntoIterator<Item = (&'a str, &'a Slice)>,
) -> Spreadsheet {
    let exponents = ["lyapunov", "lyapunov_error"].map(|name| timed(info, name, "1/s"));
    let mut head = ["sweep", name, "motion"].map(str::to_owned).to_vec();
    head.extend(exponents);
    for prefix in ["min_", "max_"] {
        let states = info.states.iter();
        head.extend(states.map(|state| label(&format!("{prefix}{}", state.name), state.unit)));
    }
    let states = info.states.len();
    let row = |sweep: &str, slice: &Slice| {
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
    };
    let mut rows = vec![head];
    rows.extend(slices.into_iter().map(|(sweep, slice)| row(sweep, slice)));
    Spreadsheet::of(rows)
}
