//! The legend: one for all panels, above them where it covers no data.

use super::curve;
use super::element::{WIDTH, words};
use crate::report::curve::Curve;
use crate::report::figure::Figure;
use crate::report::text::width;

/// Heights and widths of what it consists of, px.
const ROW: f64 = 20.0;
const FIRST: f64 = 16.0;
const SAMPLE: f64 = 30.0;
const TEXT: f64 = 12.5;
const GAP: f64 = 8.0;

/// The legend, which begins this far to the right, and where it ends, px.
pub(super) fn draw(figure: &Figure, left: f64) -> (String, f64) {
    let (mut legend, mut x, mut y) = (String::new(), left, FIRST);
    let entries = entries(figure);
    for entry in &entries {
        let length = SAMPLE + GAP + TEXT * width(&entry.label);
        if x + length > WIDTH && x > left {
            (x, y) = (left, y + ROW);
        }
        legend += &curve::sample(entry, [x, y], SAMPLE);
        let place = [x + SAMPLE + GAP, y + 0.36 * TEXT];
        legend += &words(&entry.label, place, TEXT, "start");
        x += length + 3.0 * GAP;
    }
    (legend, if entries.is_empty() { 0.0 } else { y + GAP })
}

/// One curve for each way in which something is drawn and named.
fn entries(figure: &Figure) -> Vec<&Curve> {
    let mut entries: Vec<&Curve> = Vec::new();
    let key = |curve: &Curve| (curve.label.clone(), curve.series, curve.shape);
    for curve in figure.panels.iter().flat_map(|panel| &panel.curves) {
        if !curve.label.is_empty() && !entries.iter().any(|entry| key(entry) == key(curve)) {
            entries.push(curve);
        }
    }
    entries
}
