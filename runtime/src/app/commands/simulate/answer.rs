//! A motion in all forms.

use crate::app::chart::axis;
use crate::app::document::{Document, named};
use crate::app::output::Answer;
use crate::app::spreadsheet::{Columns, Spreadsheet};
use crate::app::text::{heading, label, line, number, short, table, time_unit, timed, work};
use crate::model::{ModelInfo, Unit};
use crate::report::{Axis, Curve, Figure, Panel};
use crate::study::{Case, Trajectory};

/// A motion of this time.
pub(super) fn answer(
    info: &ModelInfo,
    case: &Case,
    motion: &Trajectory,
    time: f64,
) -> Answer<'static> {
    let (text, document) = (
        describe(info, case, motion, time),
        document(info, case, motion),
    );
    let answer = Answer::new("trajectory", text, document);
    drawn("trajectory", answer, info, motion)
}

/// An answer with the table and the picture of a motion, by this name.
pub(in crate::app::commands) fn drawn<'a>(
    name: &str,
    answer: Answer<'a>,
    info: &ModelInfo,
    motion: &Trajectory,
) -> Answer<'a> {
    answer
        .sheet(name, sheet(info, motion))
        .figure(name, picture(info, motion))
}

/// One row for each time.
fn sheet(info: &ModelInfo, motion: &Trajectory) -> Spreadsheet {
    let all = lines(info, motion);
    let lines: Vec<&Line> = all.iter().flatten().collect();
    let heads = lines.iter().map(|line| label(line.name, line.unit));
    let columns = Columns::new()
        .number(timed(info, "t", "s"), |&i: &usize| Some(motion.times[i]))
        .numbers(heads, |&i, j| lines[j].values.get(i).copied());
    columns.sheet(&(0..motion.times.len()).collect::<Vec<_>>())
}

/// Digits shown of a state.
const DIGITS: usize = 8;

fn describe(info: &ModelInfo, case: &Case, motion: &Trajectory, time: f64) -> String {
    let what = format!("a motion of {}{}", short(time), time_unit(info));
    let [states, observables, forces] = lines(info, motion);
    let row = |line: &Line, more: &[Option<&f64>]| {
        let values = [line.values.first(), line.values.last()];
        let values = values.iter().chain(more).flatten();
        let shown = values.map(|&&value| number(value, DIGITS));
        self::line([label(line.name, line.unit)].into_iter().chain(shown))
    };
    let mut text = "state\tstart\tend\tmin\tmax\n".to_owned();
    for (j, line) in states.iter().enumerate() {
        text += &row(line, &[motion.min.get(j), motion.max.get(j)]);
    }
    let others: String = observables
        .iter()
        .chain(&forces)
        .map(|line| row(line, &[]))
        .collect();
    let states = table(&text);
    let others = match others.as_str() {
        "" => String::new(),
        others => table(&format!("quantity\tstart\tend\n{others}")),
    };
    let (samples, work) = (motion.times.len(), work(&motion.work));
    heading(info, case, &what) + &format!("{states}{others}\n  {samples} samples; {work}\n")
}

/// A motion, each quantity as one column.
fn document<'a>(info: &'a ModelInfo, case: &Case, motion: &Trajectory) -> Document<'a> {
    let [states, observables, forces] = lines(info, motion).map(|lines| {
        let names = lines.iter().map(|line| line.name);
        named(names, lines.iter().map(|line| &line.values))
    });
    Document::case(info, case)
        .put("time", &motion.times)
        .put("states", states)
        .put("observables", observables)
        .put("forces", forces)
        .states("state", motion.states.last().into_iter().flatten())
        .states("max", &motion.max)
        .states("min", &motion.min)
        .units()
}

/// Curves that one panel may hold and still be read.
const CURVES: usize = 6;

/// Samples of a quantity that a figure shows; more could not be told apart.
const SAMPLES: usize = 2000;

/// A quantity along the motion.
struct Line {
    name: &'static str,
    unit: Option<Unit>,
    values: Vec<f64>,
}

/// The states, observables and friction forces along the motion.
fn lines(info: &ModelInfo, motion: &Trajectory) -> [Vec<Line>; 3] {
    let states = info.states.iter().map(|one| (one.name, one.unit));
    let observables = info.observables.iter().map(|one| (one.name, one.unit));
    let rubbing = info.contacts.iter().map(|one| (one.name, one.unit));
    let forces = rubbing.chain(info.presses.iter().map(|one| (one.name, one.unit)));
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
fn picture(info: &ModelInfo, motion: &Trajectory) -> Figure {
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
