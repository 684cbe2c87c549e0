//! Error against cost.

use stickslip::report::Curve;
use stickslip::study::trade::{Precision, Trade};

use super::super::words::evaluations;

/// Errors above this are of no use to anyone.
const USELESS: f64 = 1.0;
/// Errors below this are those of the exact orbit against which the others are measured.
const RESOLUTION: f64 = 1e-10;
/// A setting that costs more must be better by this factor.
const BETTER: f64 = 0.9;

/// Cost and error of every setting, from the cheapest to the most accurate, without those that another one beats.
fn best<'a>(precisions: impl Iterator<Item = &'a Precision>) -> Vec<[f64; 2]> {
    let mut all: Vec<[f64; 2]> = precisions
        .flat_map(|precision| &precision.points)
        .map(|point| [evaluations(&point.cost.work) as f64, point.total])
        .filter(|[_, error]| *error > RESOLUTION)
        .collect();
    all.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut least = USELESS;
    all.retain(|&[_, error]| {
        let better = error < BETTER * least;
        least = least.min(error);
        better
    });
    all
}

/// One curve for each smoothing, and the exact system.
pub(super) fn curves(trades: &[Trade]) -> Vec<Curve> {
    let copies = trades.iter().enumerate().filter_map(|(i, trade)| {
        let kernel = trade.curves.first()?.kernel;
        let copies = trade.precision.iter().filter(|p| p.smoothing.is_some());
        Some(Curve::line(kernel.to_string(), i + 1, best(copies)))
    });
    let exact = trades.first().map(|trade| {
        let exact = trade.precision.iter().filter(|p| p.smoothing.is_none());
        Curve::line("exact", 0, best(exact))
    });
    copies.chain(exact).collect()
}
