//! The map as a section of the report: a picture for each system, and all cells in a table.

use stickslip::report::numerals::{decimals, power};
use stickslip::report::symbols::typeset;
use stickslip::report::{Axis, Curve, Manuscript, Marker, Panel, ReportError, Section};

use super::{Cell, Outcome, Range};

/// The section on the extremes.
pub(in super::super) fn section(map: &[(Range, Vec<Cell>)]) -> Result<Section, ReportError> {
    let manuscript = Manuscript::new(include_str!("extremes.md"));
    let manuscript = (1..=4).fold(manuscript, |manuscript, i| {
        let ranges = map.iter().filter(|(range, _)| place(range) == i);
        let panels = ranges.map(|(range, cells)| panel(range, cells));
        manuscript.panels(&format!("E.{i}"), panels)
    });
    manuscript.rows("extremes", rows(map)).section()
}

/// Free decades at both ends of an axis.
const MARGIN: f64 = 0.6;

/// The place among the figures, from 1, of the one that shows a range.
fn place(range: &Range) -> usize {
    match range.system() {
        _ if range.is_copy() => 4,
        "belt-oscillator" => 2,
        "belt-pair" => 3,
        _ => 1,
    }
}

fn panel(range: &Range, cells: &[Cell]) -> Panel {
    let cells = || cells.iter().filter(|cell| cell.value > 0.0);
    let points = |of: fn(&Outcome) -> Option<f64>| {
        let points = cells().filter_map(|cell| Some([cell.value.log10(), of(&cell.outcome)?]));
        points.collect::<Vec<_>>()
    };
    let claimed = points(|outcome| match outcome {
        Outcome::Found { claimed, .. } => Some(*claimed),
        Outcome::Refused { .. } => None,
    });
    let confirmed = points(|outcome| match outcome {
        Outcome::Found { digits, .. } => Some(*digits),
        Outcome::Refused { .. } => None,
    });
    let refused = points(|outcome| matches!(outcome, Outcome::Refused { .. }).then_some(0.0));
    let curves = [
        Curve::line("claimed", 2, claimed),
        Curve::points("confirmed", 1, Marker::Circle, confirmed),
        Curve::points("an error", 3, Marker::Cross, refused),
    ];
    let powers = || cells().map(|cell| cell.value.log10());
    let first = powers().fold(f64::INFINITY, f64::min) - MARGIN;
    let last = powers().fold(f64::NEG_INFINITY, f64::max) + MARGIN;
    Panel::new(
        Axis::new(&format!("log_{{10}} {}", range.axis)).from(first, last),
        Axis::new("digits").from(0.0, 16.0),
    )
    .titled(format!("{}: {}", range.system(), typeset(range.varied())))
    .curves(curves.into_iter().filter(|curve| !curve.points.is_empty()))
}

fn rows(map: &[(Range, Vec<Cell>)]) -> Vec<Vec<String>> {
    let rows = map.iter().flat_map(|(range, cells)| {
        cells.iter().map(|cell| {
            let (digits, claimed, reason) = match &cell.outcome {
                Outcome::Found {
                    digits, claimed, ..
                } => (decimals(*digits, 1), decimals(*claimed, 1), String::new()),
                Outcome::Refused { kind, .. } => (String::new(), String::new(), (*kind).to_owned()),
            };
            vec![
                range.system().to_owned(),
                range.varied().to_owned(),
                value(cell.value),
                digits,
                claimed,
                reason,
            ]
        })
    });
    rows.collect()
}

fn value(value: f64) -> String {
    if value == 0.0 {
        "0".to_owned()
    } else {
        power(value.log10().round() as i32)
    }
}
