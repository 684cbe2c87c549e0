//! Predicted beside measured errors.

use stickslip::study::trade::{Point, Trade};

use super::super::words::{decimals, exponent, power, scientific};

/// Exponents of the sizes shown.
const SHOWN: [i32; 4] = [3, 4, 5, 7];

/// Predicted and measured errors of frequency and largest displacement.
pub(super) fn rows(trades: &[Trade]) -> Vec<Vec<String>> {
    let rows = trades
        .iter()
        .flat_map(|trade| &trade.curves)
        .flat_map(|curve| {
            let shown = |point: &&Point| SHOWN.contains(&exponent(point.size));
            let points = curve.points.iter().filter(shown);
            points.map(|point| row(&curve.kernel.to_string(), point))
        });
    rows.collect()
}

fn row(kernel: &str, point: &Point) -> Vec<String> {
    let predicted = point.predicted.as_ref().ok();
    let frequency = predicted.map(|p| p.frequency);
    let extremum = predicted.and_then(|p| p.max_abs.first().copied().flatten());
    let measured = point.max_abs.first().copied().unwrap_or(f64::NAN);
    let doubts = predicted.is_none_or(|p| !p.doubts.is_empty());
    let mut row = vec![kernel.to_owned(), power(exponent(point.size))];
    row.extend(compared(frequency, point.frequency));
    row.extend(compared(extremum, measured));
    row.push(if doubts { "not yet" } else { "yes" }.to_owned());
    row
}

fn compared(predicted: Option<f64>, measured: f64) -> [String; 3] {
    let none = || "–".to_owned();
    [
        predicted.map_or_else(none, |p| scientific(p, 3)),
        scientific(measured, 3),
        predicted.map_or_else(none, |p| decimals(p / measured, 3)),
    ]
}
