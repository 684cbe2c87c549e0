//! A motion as a figure.

use crate::app::axis::axis;
use crate::app::show::{Kind, Quantity, family};
use crate::app::text::timed;
use crate::model::ModelInfo;
use crate::report::symbols::typeset;
use crate::report::{Axis, Coordinate, Curve, Figure, Marker, Panel, traced};
use crate::study::{Envelope, Trajectory};

/// Curves that one panel may hold and still be read.
const CURVES: usize = 6;

/// The quantities against time, and the first two states against each other.
pub(super) fn picture(info: &ModelInfo, motion: &Trajectory, shown: &[Quantity]) -> Figure {
    let panels = alike(motion, shown);
    let panels = panels.iter().map(|group| against_time(info, motion, group));
    let figure = Figure::new("", info.name, String::new()).columns(2);
    let figure = panels.fold(figure, Figure::panel);
    match pair(info, shown) {
        Some(pair) => figure.panel(plane(motion, pair)),
        None => figure,
    }
}

/// How often a quantity moves farther than another one that can be read off the same axis.
const READABLE: f64 = 20.0;

/// Groups of quantities of a kind with the same unit, all of which can be read off one axis; without units, each by itself.
fn alike<'a>(motion: &Trajectory, shown: &'a [Quantity]) -> Vec<Vec<&'a Quantity>> {
    let mut groups: Vec<Vec<&Quantity>> = Vec::new();
    for one in shown {
        let text = |one: &Quantity| (one.of, one.unit.map(|unit| unit.text));
        let fits = |group: &&mut Vec<&Quantity>| {
            let ratio = extent(motion, group[0]) / extent(motion, one);
            one.unit.is_some()
                && text(group[0]) == text(one)
                && group.len() < CURVES
                && (ratio.is_nan() || (1.0 / READABLE..=READABLE).contains(&ratio))
        };
        match groups.iter_mut().find(fits) {
            Some(group) => group.push(one),
            None => groups.push(vec![one]),
        }
    }
    groups
}

/// How far a quantity moves.
fn extent(motion: &Trajectory, one: &Quantity) -> f64 {
    let values = || thinned(motion, one).into_iter().map(|[_, value]| value);
    values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
}

fn against_time(info: &ModelInfo, motion: &Trajectory, group: &[&Quantity]) -> Panel {
    let names: Vec<&str> = group.iter().map(|one| one.name).collect();
    let y = axis(&names.join(", "), group.first().and_then(|one| one.unit));
    let panel = Panel::new(Axis::new(&timed(info, "time", "s")), y);
    let curves = group.iter().enumerate().map(|(series, one)| {
        let label = if group.len() > 1 {
            typeset(one.name)
        } else {
            String::new()
        };
        if one.of == Kind::State && !motion.rates.is_empty() {
            return traced(
                label,
                series,
                motion,
                [Coordinate::Time, Coordinate::State(one.index)],
            );
        }
        Curve::line(label, series, thinned(motion, one))
    });
    panel.curves(curves)
}

/// A quantity against time, with its peaks.
fn thinned(motion: &Trajectory, one: &Quantity) -> Vec<[f64; 2]> {
    let rows = match one.of {
        Kind::State => {
            let envelope = motion.envelopes.get(one.index);
            return envelope.map_or_else(Vec::new, Envelope::points);
        }
        Kind::Observable => &motion.observables,
        Kind::Force => &motion.forces,
    };
    let rows = motion.times.iter().zip(rows);
    let points = rows.filter_map(|(t, row)| Some([*t, *row.get(one.index)?]));
    points.collect::<Envelope>().points()
}

/// The states that span a plane: the first two that are shown, of many such as belong to different arrays.
fn pair<'a>(info: &ModelInfo, shown: &'a [Quantity]) -> Option<[&'a Quantity; 2]> {
    let mut states = shown.iter().filter(|one| one.of == Kind::State);
    let first = states.next()?;
    let many = shown.len() < info.states.len();
    let second = states.find(|one| !many || family(one.name) != family(first.name))?;
    Some([first, second])
}

fn plane(motion: &Trajectory, pair: [&Quantity; 2]) -> Panel {
    let [x, y] = pair.map(|one| axis(one.name, one.unit));
    let path = traced("", 0, motion, pair.map(|one| Coordinate::State(one.index)));
    Panel::new(x, y).curve(if motion.every == 1 {
        path
    } else {
        // What lies between two rows of many is not known any more.
        Curve::points("", 0, Marker::Dot, path.points)
    })
}
