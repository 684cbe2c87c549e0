//! A branch of equilibria as a figure.

use crate::app::chart::{Chart, Mark, Point, along_axis, axis};
use crate::model::ModelInfo;
use crate::report::{Figure, Panel};
use crate::study::{EquilibriaRecord, EquilibriumRecord, SpecialEquilibrium};

/// The first state.
pub(super) fn picture(info: &ModelInfo, branch: &EquilibriaRecord) -> Figure {
    let first = info.states.first();
    let name = first.map_or("", |state| state.name);
    let y = axis(name, first.and_then(|state| state.unit));
    let mut chart = Chart::new(Panel::new(along_axis(info, &branch.along), y));
    let value = |state: &[f64]| state.first().copied().unwrap_or(0.0);
    let point = |one: &EquilibriumRecord| {
        Some(Point {
            at: [one.r?, value(&one.state)],
            beside: value(&one.state),
            stability: one.stability,
        })
    };
    let mark = |one: &SpecialEquilibrium| Mark {
        kind: one.kind,
        label: one.label.clone(),
        at: [one.r, value(&one.state)],
        beside: value(&one.state),
    };
    let points: Vec<Point> = branch.points.iter().filter_map(point).collect();
    chart.add(&points, branch.special.iter().map(mark).collect());
    Figure::new("", info.name, String::new()).panel(chart.panel())
}
