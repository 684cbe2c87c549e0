//! The map as a section of the report: a picture for each system, and all cells in a table.

use stickslip::report::{Axis, Column, Curve, Figure, Marker, Panel, Section, Table};

use super::super::words::{decimals, power};
use super::ranges::System;
use super::{Cell, Outcome, Range, map};

/// The section on the extremes.
pub(in super::super) fn section() -> Section {
    from(&map())
}

pub(super) fn from(map: &[(Range, Vec<Cell>)]) -> Section {
    let section = Section::new("At the extremes").text(
        "A program that ends with a wrong number is worse than one that fails. Here every parameter of every system, \
         and the size of every smoothing, is taken outwards by decades, and each answer is judged: by a much tighter \
         computation of the same orbit, and wherever the motion is known in closed form, exactly or in a limit, by \
         that. The digits are those on which they agree for period and extrema. Where there is no answer, an error says \
         why: a cross on the axis. The accuracy asked for is 10^{−9} throughout.",
    );
    let figures = (0..FIGURES.len()).map(|i| figure(i, map));
    figures.fold(section, Section::figure).table(table(map))
}

/// Free decades at both ends of an axis.
const MARGIN: f64 = 0.6;

const FIGURES: [(&str, &str); 4] = [
    ("E.1", "Van der Pol oscillator and drill string"),
    ("E.2", "One mass on a belt"),
    ("E.3", "Two masses on a belt"),
    (
        "E.4",
        "Smooth copies: one mass on a belt, and (quartic) the drill string",
    ),
];

/// The place among the figures of the one that shows a range.
fn place(range: &Range) -> usize {
    match range.system {
        _ if range.is_copy() => 3,
        System::VanDerPol | System::DrillString => 0,
        System::BeltOscillator => 1,
        System::BeltPair => 2,
    }
}

fn figure(i: usize, map: &[(Range, Vec<Cell>)]) -> Figure {
    let (number, title) = FIGURES[i];
    let figure = Figure::new(
        number,
        title,
        "Decimal digits of period and extrema that are confirmed, and that the answer claims for itself. Crosses: no \
         answer, but the reason why.",
    )
    .columns(2);
    let ranges = map.iter().filter(|(range, _)| place(range) == i);
    ranges.fold(figure, |figure, (range, cells)| {
        figure.panel(panel(range, cells))
    })
}

fn panel(range: &Range, cells: &[Cell]) -> Panel {
    let cells = || cells.iter().filter(|cell| cell.value > 0.0);
    let found = |of: fn(f64, f64) -> f64| {
        cells()
            .filter_map(|cell| match cell.outcome {
                Outcome::Found {
                    digits, claimed, ..
                } => Some([cell.value.log10(), of(digits, claimed)]),
                Outcome::Refused { .. } => None,
            })
            .collect::<Vec<_>>()
    };
    let refused = cells().filter(|cell| matches!(cell.outcome, Outcome::Refused { .. }));
    let mut curves = vec![
        Curve::line("claimed", 2, found(|_, claimed| claimed)),
        Curve::points("confirmed", 1, Marker::Circle, found(|digits, _| digits)),
    ];
    let refused: Vec<[f64; 2]> = refused.map(|cell| [cell.value.log10(), 0.0]).collect();
    let powers = || cells().map(|cell| cell.value.log10());
    let first = powers().fold(f64::INFINITY, f64::min) - MARGIN;
    let last = powers().fold(f64::NEG_INFINITY, f64::max) + MARGIN;
    if !refused.is_empty() {
        curves.push(Curve::points("an error", 3, Marker::Cross, refused));
    }
    Panel::new(
        Axis::new(&format!("log_{{10}} {}", range.axis)).from(first, last),
        Axis::new("digits").from(0.0, 16.0),
    )
    .titled(format!("{}: {}", range.system.command(), range.varied))
    .curves(curves.into_iter().filter(|curve| !curve.points.is_empty()))
}

fn table(map: &[(Range, Vec<Cell>)]) -> Table {
    let columns = [
        Column::words("system"),
        Column::words("varied"),
        Column::numbers("value"),
        Column::numbers("digits"),
        Column::numbers("claimed"),
        Column::words("instead of an answer"),
    ];
    let table = Table::new(
        "extremes",
        "Every cell of the map. *Digits* are confirmed, *claimed* is what the answer's own error estimate says.",
        columns,
    );
    let rows = map.iter().flat_map(|(range, cells)| {
        cells.iter().map(|cell| {
            let (digits, claimed, reason) = match &cell.outcome {
                Outcome::Found {
                    digits, claimed, ..
                } => (decimals(*digits, 1), decimals(*claimed, 1), String::new()),
                Outcome::Refused { kind, .. } => (String::new(), String::new(), (*kind).to_owned()),
            };
            vec![
                range.system.command().to_owned(),
                range.varied.to_owned(),
                value(cell.value),
                digits,
                claimed,
                reason,
            ]
        })
    });
    table.rows(rows)
}

fn value(value: f64) -> String {
    if value == 0.0 {
        "0".to_owned()
    } else {
        power(value.log10().round() as i32)
    }
}
