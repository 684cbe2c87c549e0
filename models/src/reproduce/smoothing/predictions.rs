//! Predicted beside measured errors.

use stickslip::report::{Column, Table};
use stickslip::study::trade::{Point, Trade};

use super::super::words::{decimals, exponent, power, scientific};

/// Exponents of the sizes shown.
const SHOWN: [i32; 4] = [3, 4, 5, 7];

/// Predicted and measured errors of frequency and largest displacement.
pub(super) fn table(trades: &[Trade]) -> Table {
    let columns = [
        Column::words("smoothing"),
        Column::numbers("*ε* (s/m)"),
        Column::numbers("*e_{f}*, predicted"),
        Column::numbers("measured"),
        Column::numbers("ratio"),
        Column::numbers("*e_{x}*, predicted"),
        Column::numbers("measured"),
        Column::numbers("ratio"),
        Column::words("in the asymptotic range"),
    ];
    let caption = "Errors of smooth copies at *v*_{dr} = 0.2 m/s, with their signs: predicted from the exact orbit, and \
                   measured by integrating the copy. All copies vibrate too fast and not far enough. A prediction is a \
                   first term: good if the layer is thin against everything else, and marked where it is not.";
    let rows = trades
        .iter()
        .flat_map(|trade| &trade.curves)
        .flat_map(|curve| {
            let shown = |point: &&Point| SHOWN.contains(&exponent(point.size));
            let points = curve.points.iter().filter(shown);
            points.map(|point| row(&curve.kernel.to_string(), point))
        });
    Table::new("predictions", caption, columns).rows(rows)
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
