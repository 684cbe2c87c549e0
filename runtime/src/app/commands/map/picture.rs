//! A map as tiles: of kinds a colour each, of values a shade.

use crate::app::axis::along_axis;
use crate::app::text::{brief, label, number, timed};
use crate::field::Design;
use crate::model::ModelInfo;
use crate::report::{Axis, COLOURS, Curve, Figure, Panel, SHADES};
use crate::study::{Asked, Grid, MapRecord, Quantity};

/// Kinds that have a colour of their own: black is for the others.
const KINDS: usize = COLOURS - 1;
/// Digits of the ends of shades.
const DIGITS: usize = 3;

pub(super) fn picture(info: &ModelInfo, record: &MapRecord, question: &str) -> Figure {
    let title = format!("{}: {question}", info.command);
    let [x, y] = [0, 1].map(|k| reach(along_axis(info, &record.grid.along[k]), &record.grid, k));
    let panel = Panel::new(x, y).titled(shown(info, record, question));
    let curves = match record.asked {
        Asked::Motion => kinds(record),
        _ => values(record),
    };
    let [n, m] = record.grid.values;
    let caption = format!("{n} by {m} nodes");
    Figure::new("1", &title, caption).panel(panel.curves(curves))
}

/// What the tiles show, with its unit, and what a place without one says.
fn shown(info: &ModelInfo, record: &MapRecord, question: &str) -> String {
    let what = match record.asked {
        Asked::Quantity(Quantity::Period, _) => timed(info, question, "s"),
        Asked::Quantity(Quantity::Amplitude, state) => label(
            question,
            info.states.get(state).and_then(|state| state.unit),
        ),
        _ => question.to_owned(),
    };
    let kinds = record.asked == Asked::Motion;
    if kinds || record.nodes.iter().all(|(_, cell)| cell.value.is_some()) {
        return what;
    }
    format!("{what}; blank where there is none")
}

/// The axis, half a tile beyond its first and last values.
fn reach(axis: Axis, grid: &Grid, k: usize) -> Axis {
    let (along, [low, high]) = (grid.along[k], ends(grid, k));
    match along.design {
        Design::Smoothing => axis.from(low, high),
        _ => {
            let half = 0.5 * (high - low) / (grid.values[k] - 1) as f64;
            axis.from(low - half, high + half)
        }
    }
}

fn ends(grid: &Grid, k: usize) -> [f64; 2] {
    let (from, to) = (grid.along[k].from, grid.along[k].to);
    [from.min(to), from.max(to)]
}

/// A tile for each kind, the most frequent first.
fn kinds(record: &MapRecord) -> Vec<Curve> {
    let mut kinds: Vec<(&str, usize)> = Vec::new();
    for (_, cell) in &record.nodes {
        match kinds.iter_mut().find(|(kind, _)| *kind == cell.kind) {
            Some((_, count)) => *count += 1,
            None => kinds.push((&cell.kind, 1)),
        }
    }
    kinds.sort_by_key(|(kind, count)| (std::cmp::Reverse(*count), *kind));
    let rest = kinds.split_off(kinds.len().min(KINDS));
    let of = |wanted: &dyn Fn(&str) -> bool| {
        let nodes = record.nodes.iter().filter(|node| wanted(&node.1.kind));
        nodes.map(|node| node.0).collect::<Vec<_>>()
    };
    let mut curves: Vec<Curve> = kinds
        .iter()
        .enumerate()
        .map(|(i, (kind, _))| {
            Curve::tiles(
                brief(kind),
                Some(i + 1),
                0,
                record.grid.values,
                of(&|one| one == *kind),
            )
        })
        .collect();
    if !rest.is_empty() {
        let others = of(&|one| rest.iter().any(|(kind, _)| *kind == one));
        let label = format!("{} more kinds", rest.len());
        curves.push(Curve::tiles(label, Some(0), 0, record.grid.values, others));
    }
    curves
}

/// Values in as many shades as there are, from the smallest to the largest.
fn values(record: &MapRecord) -> Vec<Curve> {
    let known: Vec<([f64; 2], f64)> = record
        .nodes
        .iter()
        .filter_map(|(place, cell)| Some((*place, cell.value?)))
        .collect();
    let low = known
        .iter()
        .fold(f64::INFINITY, |low, (_, value)| low.min(*value));
    let high = known
        .iter()
        .fold(f64::NEG_INFINITY, |high, (_, value)| high.max(*value));
    let end = |shade: usize| low + (high - low) * shade as f64 / SHADES as f64;
    let shade_of = |value: f64| {
        let share = (value - low) / (high - low) * SHADES as f64;
        if share.is_finite() {
            (share as usize).min(SHADES - 1)
        } else {
            0
        }
    };
    let tiles = |shade: usize| {
        let points: Vec<[f64; 2]> = known
            .iter()
            .filter(|(_, value)| shade_of(*value) == shade)
            .map(|(place, _)| *place)
            .collect();
        let label = format!(
            "{}..{}",
            number(end(shade), DIGITS),
            number(end(shade + 1), DIGITS)
        );
        (!points.is_empty()).then(|| Curve::tiles(label, None, shade, record.grid.values, points))
    };
    (0..SHADES).filter_map(tiles).collect()
}
