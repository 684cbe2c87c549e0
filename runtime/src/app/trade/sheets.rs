//! A trade as CSV.

use super::words;
use crate::app::spreadsheet::{Spreadsheet, full};
use crate::app::text::timed;
use crate::field::Kernel;
use crate::model::ModelInfo;
use crate::study::trade::{Point, Precision};

/// Errors, one row for each copy at each end.
pub(super) fn errors<'a>(
    info: &ModelInfo,
    copies: impl IntoIterator<Item = (usize, Kernel, &'a Point)>,
) -> Spreadsheet {
    let mut head = words([
        "end",
        "kernel",
        "size",
        &timed(info, "stiffness", "1/s"),
        "frequency",
        "predicted_frequency",
        "leading",
    ]);
    for state in info.states {
        head.extend([
            format!("max_abs_{}", state.name),
            format!("predicted_max_abs_{}", state.name),
        ]);
    }
    head.extend(words([
        "asymptotic",
        "resolution",
        "steps",
        "linearisations",
        "factorisations",
        "seconds",
    ]));
    let mut rows = vec![head];
    let row = |(end, kernel, point)| sheet_row(end, kernel, point);
    rows.extend(copies.into_iter().map(row));
    Spreadsheet::of(rows)
}

fn sheet_row(end: usize, kernel: Kernel, point: &Point) -> Vec<String> {
    let predicted = point.predicted.as_ref().ok();
    let told = |value: Option<f64>| value.as_ref().map(full).unwrap_or_default();
    let mut row = vec![
        end.to_string(),
        kernel.to_string(),
        full(&point.size),
        full(&point.stiffness),
        full(&point.frequency),
        told(predicted.map(|found| found.frequency)),
        told(predicted.and_then(|found| found.leading)),
    ];
    for (j, error) in point.max_abs.iter().enumerate() {
        let found = predicted.and_then(|found| found.max_abs.get(j).copied().flatten());
        row.extend([full(error), told(found)]);
    }
    let work = &point.cost.work;
    row.push(
        predicted
            .is_some_and(|found| found.doubts.is_empty())
            .to_string(),
    );
    row.push(full(&point.resolution));
    row.extend(
        [work.steps, work.linearisations, work.factorisations].map(|count| count.to_string()),
    );
    row.push(full(&point.cost.seconds));
    row
}

/// Work-precision curves, one row for each orbit.
pub(super) fn precision<'a>(
    curves: impl IntoIterator<Item = (usize, &'a Precision)>,
) -> Spreadsheet {
    let mut rows = vec![words([
        "end",
        "dynamics",
        "tolerance",
        "integration_error",
        "total_error",
        "steps",
        "evaluations",
        "linearisations",
        "factorisations",
        "seconds",
    ])];
    for (end, precision) in curves {
        for point in &precision.points {
            let mut row = vec![end.to_string(), precision.dynamics()];
            row.extend([point.tolerance, point.integration, point.total].map(|value| full(&value)));
            let work = &point.cost.work;
            let counts = [
                work.steps,
                work.evaluations,
                work.linearisations,
                work.factorisations,
            ];
            row.extend(counts.map(|count| count.to_string()));
            row.push(full(&point.cost.seconds));
            rows.push(row);
        }
    }
    Spreadsheet::of(rows)
}
