//! A trade as CSV.

use super::words;
use crate::model::ModelInfo;
use crate::study::TradeRecord;
use crate::study::app::spreadsheet::{Spreadsheet, full};
use crate::study::app::text::timed;
use crate::study::trade::{Curve, Point};

/// Errors, one row for each copy at each end.
pub(super) fn errors(info: &ModelInfo, record: &TradeRecord) -> Spreadsheet {
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
    for (end, at) in record.ends.iter().enumerate() {
        for curve in &at.trade.curves {
            rows.extend(
                curve
                    .points
                    .iter()
                    .map(|point| sheet_row(end, curve, point)),
            );
        }
    }
    Spreadsheet::of(rows)
}

fn sheet_row(end: usize, curve: &Curve, point: &Point) -> Vec<String> {
    let predicted = point.predicted.as_ref().ok();
    let told = |value: Option<f64>| value.as_ref().map(full).unwrap_or_default();
    let mut row = vec![
        end.to_string(),
        curve.kernel.to_string(),
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
pub(super) fn precision(record: &TradeRecord) -> Spreadsheet {
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
    for (end, at) in record.ends.iter().enumerate() {
        for precision in &at.trade.precision {
            for point in &precision.points {
                let mut row = vec![end.to_string(), precision.dynamics()];
                row.extend(
                    [point.tolerance, point.integration, point.total].map(|value| full(&value)),
                );
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
    }
    Spreadsheet::of(rows)
}
