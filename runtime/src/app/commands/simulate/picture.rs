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
pub(super) struct Line {
    pub(super) name: &'static str,
    pub(super) unit: Option<Unit>,
    pub(super) values: Vec<f64>,
}

/// The states, observables and friction forces along the motion.
pub(super) fn lines(info: &ModelInfo, motion: &Trajectory) -> [Vec<Line>; 3] {
    let states = info.states.iter().map(|one| (one.name, one.unit));
    let observables = info.observables.iter().map(|one| (one.name, one.unit));
    let forces = info.contacts.iter().map(|one| (one.name, one.unit));
    [
        along(states, &motion.states),
        along(observables, &motion.observables),
        along(forces, &motion.forces),
    ]
}

fn along(
    named: impl Iterator<Item = (&'static str, Option<Unit>)>,
    rows: &[Vec<f64>],
) -> Vec<Line> {
    let column = |j: usize| rows.iter().filter_map(|row| row.get(j).copied()).collect();
    let line = |(j, (name, unit))| Line {
        name,
        unit,
        values: column(j),
    };
    named.enumerate().map(line).collect()
}

/// The motion as a figure.
pub(super) fn picture(info: &ModelInfo, motion: &Trajectory) -> Figure {
    let [states, _, forces] = lines(info, motion);
    let groups = alike(&states).into_iter().chain(alike(&forces));
    let panels = groups.map(|lines| against_time(info, motion, &lines));
    let figure = Figure::new("", info.name, String::new()).columns(2);
    let mut figure = panels.fold(figure, Figure::panel);
    if let [first, second, ..] = states.as_slice() {
        figure = figure.panel(plane(first, second));
    }
    figure
}

/// Groups of lines with the same unit; without units, each line by itself.
fn alike(lines: &[Line]) -> Vec<Vec<&Line>> {
    let mut groups: Vec<Vec<&Line>> = Vec::new();
    for line in lines {
        let text = |line: &Line| line.unit.map(|unit| unit.text);
        let fits = |group: &&mut Vec<&Line>| {
            line.unit.is_some() && text(group[0]) == text(line) && group.len() < CURVES
        };
        match groups.iter_mut().find(fits) {
            Some(group) => group.push(line),
            None => groups.push(vec![line]),
        }
    }
    groups
}

fn against_time(info: &ModelInfo, motion: &Trajectory, lines: &[&Line]) -> Panel {
    let names: Vec<&str> = lines.iter().map(|line| line.name).collect();
    let y = axis(&names.join(", "), lines.first().and_then(|line| line.unit));
    let several = lines.len() > 1;
    lines.iter().enumerate().fold(
        Panel::new(Axis::new(&timed(info, "time", "s")), y),
        |panel, (series, line)| {
            let points = motion.times.iter().zip(&line.values);
            let points = points.map(|(t, value)| [*t, *value]);
            let label = if several { line.name } else { "" };
            panel.curve(Curve::line(label, series, thinned(points)))
        },
    )
}

fn plane(first: &Line, second: &Line) -> Panel {
    let points = first.values.iter().zip(&second.values);
    let points = points.map(|(x, y)| [*x, *y]).collect();
    let [x, y] = [first, second].map(|line| axis(line.name, line.unit));
    Panel::new(x, y).curve(Curve::line("", 0, points))
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
