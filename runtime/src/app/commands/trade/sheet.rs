//! A trade as CSV.

use crate::app::spreadsheet::{Columns, Head, Row, Spreadsheet, headed};
use crate::app::text::timed;
use crate::field::{Kernel, Work};
use crate::model::ModelInfo;
use crate::study::TradeRecord;
use crate::study::predict::Prediction;
use crate::study::trade::{Cost, Point, Precision, PrecisionPoint};

/// The columns of the copies of a kernel at one end.
pub(super) fn copies(
    info: &'static ModelInfo,
    end: usize,
    kernel: Kernel,
) -> Columns<'static, Point> {
    let states = info.states.iter();
    let errors = states.flat_map(|state| {
        ["", "predicted_"].map(|prefix| format!("{prefix}max_abs_{}_error", state.name))
    });
    let error = |point: &Point, j: usize| match j % 2 {
        0 => point.max_abs.get(j / 2).copied(),
        _ => predicted(point)?.max_abs.get(j / 2).copied().flatten(),
    };
    let asymptotic = |point: &Point| predicted(point).is_some_and(|found| found.doubts.is_empty());
    let columns = Columns::new()
        .count("end", move |_: &Point| end)
        .column("kernel", move |_| kernel.to_string())
        .number("size", |point| point.size)
        .number(timed(info, "stiffness", "1/s"), |point| {
            Some(point.stiffness)
        })
        .number("frequency_error", |point| point.frequency)
        .number("predicted_frequency_error", |point| {
            Some(predicted(point)?.frequency)
        })
        .number("leading", |point| predicted(point)?.leading)
        .numbers(errors, error)
        .truth("asymptotic", asymptotic)
        .column("cancelling", move |point| cancelling(info, point))
        .number("resolution", |point| point.resolution);
    counted(columns, &[STEPS, LINEARISATIONS, FACTORISATIONS], |point| {
        &point.cost
    })
}

/// The states of whose predicted error contributions cancel.
fn cancelling(info: &ModelInfo, point: &Point) -> String {
    let found = predicted(point).map_or(&[][..], |found| &found.cancelling);
    let names = info
        .states
        .iter()
        .zip(found)
        .filter(|(_, cancels)| **cancels);
    names
        .map(|(state, _)| state.name)
        .collect::<Vec<_>>()
        .join(" ")
}

fn predicted(point: &Point) -> Option<&Prediction> {
    point.predicted.as_ref().ok()
}

/// The columns of a work-precision curve at one end.
fn precision(end: usize, dynamics: String) -> Columns<'static, PrecisionPoint> {
    let columns = Columns::new()
        .count("end", move |_: &PrecisionPoint| end)
        .column("dynamics", move |_| dynamics.clone())
        .number("tolerance", |point| point.tolerance)
        .number("integration_error", |point| point.integration)
        .number("total_error", |point| point.total);
    let counts = [STEPS, EVALUATIONS, LINEARISATIONS, FACTORISATIONS];
    counted(columns, &counts, |point| &point.cost)
}

/// One row for each orbit of a work-precision curve.
pub(super) fn precision_rows(end: usize, curve: &Precision) -> Vec<Row> {
    let columns = precision(end, curve.dynamics());
    curve
        .points
        .iter()
        .map(|point| columns.row(point))
        .collect()
}

pub(super) fn precision_head() -> Vec<Head> {
    precision(0, String::new()).head()
}

/// All copies.
pub(super) fn errors(info: &'static ModelInfo, record: &TradeRecord) -> Spreadsheet {
    let rows = record.ends.iter().enumerate().flat_map(|(end, at)| {
        let curves = at.trade.curves.iter();
        curves.flat_map(move |curve| {
            let columns = copies(info, end, curve.kernel);
            curve.points.iter().map(move |point| columns.row(point))
        })
    });
    headed(copies(info, 0, Kernel::Arctan).head(), rows)
}

/// All work-precision curves.
pub(super) fn precisions(record: &TradeRecord) -> Spreadsheet {
    let rows = record.ends.iter().enumerate().flat_map(|(end, at)| {
        let curves = at.trade.precision.iter();
        curves.flat_map(move |curve| precision_rows(end, curve))
    });
    headed(precision_head(), rows)
}

/// A number of the work.
type Count = (&'static str, fn(&Work) -> u64);

const STEPS: Count = ("steps", |work| work.steps);
const EVALUATIONS: Count = ("evaluations", |work| work.evaluations);
const LINEARISATIONS: Count = ("linearisations", |work| work.linearisations);
const FACTORISATIONS: Count = ("factorisations", |work| work.factorisations);

/// More columns for these counts, and for the time.
fn counted<T: 'static>(
    columns: Columns<'static, T>,
    counts: &[Count],
    cost: fn(&T) -> &Cost,
) -> Columns<'static, T> {
    let counts = counts.iter().copied();
    let columns = counts.fold(columns, |columns, (name, count)| {
        columns.count(name, move |one| count(&cost(one).work))
    });
    columns.number("seconds", move |one| Some(cost(one).seconds))
}
