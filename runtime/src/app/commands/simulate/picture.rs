//! A motion: states and friction forces against time, and its path in the plane of two states.

use crate::app::chart::axis;
use crate::app::text::timed;
use crate::model::{ModelInfo, Unit};
use crate::report::{Axis, Curve, Figure, Panel};
use crate::study::Trajectory;

/// Curves that one panel may hold and still be read.
const CURVES: usize = 6;

/// Samples of a quantity that a figure shows; more could not be told apart.
const SAMPLES: usize = 2000;

/// A quantity along the motion.
struct Line<'a> {
    name: &'static str,
    unit: Option<Unit>,
    values: &'a [Vec<f64>],
    column: usize,
}

/// The motion as a figure.
pub(super) fn picture(info: &ModelInfo, motion: &Trajectory) -> Figure {
    let states = info.states.iter().enumerate().map(|(column, state)| Line {
        name: state.name,
        unit: state.unit,
        values: &motion.states,
        column,
    });
    let forces = info
        .contacts
        .iter()
        .enumerate()
        .map(|(column, contact)| Line {
            name: contact.name,
            unit: contact.unit,
            values: &motion.forces,
            column,
        });
    let (states, forces): (Vec<_>, Vec<_>) = (states.collect(), forces.collect());
    let mut figure = Figure::new("", info.name, String::new()).columns(2);
    for lines in alike(&states).iter().chain(&alike(&forces)) {
        figure = figure.panel(against_time(info, motion, lines));
    }
    if let [first, second, ..] = states.as_slice() {
        figure = figure.panel(plane(first, second));
    }
    figure
}

/// Groups of lines with the same unit; without units, each line by itself.
fn alike<'a, 'b>(lines: &'b [Line<'a>]) -> Vec<Vec<&'b Line<'a>>> {
    let mut groups: Vec<Vec<&Line<'_>>> = Vec::new();
    for line in lines {
        let text = |line: &Line<'_>| line.unit.map(|unit| unit.text);
        let fits = |group: &&mut Vec<&Line<'_>>| {
            line.unit.is_some() && text(group[0]) == text(line) && group.len() < CURVES
        };
        match groups.iter_mut().find(fits) {
            Some(group) => group.push(line),
            None => groups.push(vec![line]),
        }
    }
    groups
}

fn against_time(info: &ModelInfo, motion: &Trajectory, lines: &[&Line<'_>]) -> Panel {
    let names: Vec<&str> = lines.iter().map(|line| line.name).collect();
    let y = axis(&names.join(", "), lines.first().and_then(|line| line.unit));
    let several = lines.len() > 1;
    lines.iter().enumerate().fold(
        Panel::new(Axis::new(&timed(info, "time", "s")), y),
        |panel, (series, line)| {
            let points = motion.times.iter().zip(line.values);
            let points = points.map(|(t, row)| [*t, row[line.column]]);
            let label = if several { line.name } else { "" };
            panel.curve(Curve::line(label, series, thinned(points)))
        },
    )
}

fn plane(first: &Line<'_>, second: &Line<'_>) -> Panel {
    let points = first
        .values
        .iter()
        .map(|row| [row[first.column], row[second.column]]);
    Panel::new(axis(first.name, first.unit), axis(second.name, second.unit)).curve(Curve::line(
        "",
        0,
        points.collect(),
    ))
}

/// Every so many points, and the last.
fn thinned(points: impl ExactSizeIterator<Item = [f64; 2]>) -> Vec<[f64; 2]> {
    let (every, count) = (points.len().div_ceil(SAMPLES).max(1), points.len());
    let kept = points
        .enumerate()
        .filter(|(i, _)| i % every == 0 || i + 1 == count);
    kept.map(|(_, point)| point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_sample_is_shown() {
        let shown = thinned((0..4999).map(|i| [f64::from(i), 0.0]));
        assert!(shown.len() <= SAMPLES + 1);
        assert_eq!(shown.last(), Some(&[4998.0, 0.0]));
    }
}
