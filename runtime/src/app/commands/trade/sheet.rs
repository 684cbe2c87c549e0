//! A trade as CSV.

use crate::app::spreadsheet::{Row, full, head as words, optional};
use crate::app::text::timed;
use crate::field::{Kernel, Work};
use crate::model::ModelInfo;
use crate::study::trade::{Point, Precision, PrecisionPoint};

/// The columns of errors.
pub(super) fn head(info: &ModelInfo) -> Row {
    let stiffness = timed(info, "stiffness", "1/s");
    let mut head = words(["end", "kernel", "size", &stiffness]);
    head.extend(words(["frequency", "predicted_frequency", "leading"]));
    for state in info.states {
        let error = format!("max_abs_{}", state.name);
        head.extend(words([&error, &format!("predicted_{error}")]));
    }
    head.extend(words(["asymptotic", "resolution"]));
    head.extend(words([
        "steps",
        "linearisations",
        "factorisations",
        "seconds",
    ]));
    head
}

/// Errors of one copy at one end.
pub(super) fn row((end, kernel, point): (usize, Kernel, &Point)) -> Row {
    let predicted = point.predicted.as_ref().ok();
    let mut row = vec![
        end.to_string(),
        kernel.to_string(),
        full(&point.size),
        full(&point.stiffness),
        full(&point.frequency),
        optional(predicted.map(|found| found.frequency)),
        optional(predicted.and_then(|found| found.leading)),
    ];
    for (j, error) in point.max_abs.iter().enumerate() {
        let found = predicted.and_then(|found| found.max_abs.get(j).copied().flatten());
        row.extend([full(error), optional(found)]);
    }
    let asymptotic = predicted.is_some_and(|found| found.doubts.is_empty());
    row.extend([asymptotic.to_string(), full(&point.resolution)]);
    let Work {
        steps,
        linearisations,
        factorisations,
        ..
    } = point.cost.work;
    row.extend([steps, linearisations, factorisations].map(|count| count.to_string()));
    row.push(full(&point.cost.seconds));
    row
}

/// The columns of work-precision curves.
pub(super) fn precision_head() -> Row {
    words([
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
    ])
}

/// A work-precision curve, one row for each orbit.
pub(super) fn precision_rows((end, curve): (usize, &Precision)) -> impl Iterator<Item = Row> {
    let row = move |point: &PrecisionPoint| {
        let mut row = vec![end.to_string(), curve.dynamics()];
        row.extend([point.tolerance, point.integration, point.total].map(|value| full(&value)));
        let Work {
            steps,
            evaluations,
            linearisations,
            factorisations,
            ..
        } = point.cost.work;
        let counts = [steps, evaluations, linearisations, factorisations];
        row.extend(counts.map(|count| count.to_string()));
        row.push(full(&point.cost.seconds));
        row
    };
    curve.points.iter().map(row)
}
