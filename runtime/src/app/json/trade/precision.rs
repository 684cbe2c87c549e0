//! Work-precision curves as JSON.

use super::{Price, price};
use crate::study::trade::{Precision, PrecisionPoint};

#[derive(serde::Serialize)]
pub(super) struct WorkPrecision<'a> {
    dynamics: String,
    points: Vec<Precise>,
    failed: Vec<Failed<'a>>,
}

#[derive(serde::Serialize)]
struct Precise {
    tolerance: f64,
    integration_error: f64,
    total_error: f64,
    cost: Price,
}

#[derive(serde::Serialize)]
struct Failed<'a> {
    tolerance: f64,
    reason: &'a str,
}

pub(super) fn work_precision(precision: &Precision) -> WorkPrecision<'_> {
    let point = |p: &PrecisionPoint| Precise {
        tolerance: p.tolerance,
        integration_error: p.integration,
        total_error: p.total,
        cost: price(&p.cost),
    };
    let failed = precision.failed.iter();
    WorkPrecision {
        dynamics: precision.dynamics(),
        points: precision.points.iter().map(point).collect(),
        failed: failed
            .map(|(tolerance, reason)| Failed {
                tolerance: *tolerance,
                reason,
            })
            .collect(),
    }
}
