//! A branch, with those that leave it, as a figure.

use crate::app::chart::{Chart, Mark, Point, along_axis, axis};
use crate::app::text::timed;
use crate::model::ModelInfo;
use crate::report::{Axis, Figure, Panel};
use crate::study::{BranchRecord, OrbitRecord, Special};

/// The extent of the first state, and the period.
pub(super) fn picture(info: &ModelInfo, branch: &BranchRecord) -> Figure {
    let parameter = along_axis(info, &branch.along);
    let first = info.states.first();
    let name = format!("max |{}|", first.map_or("", |state| state.name));
    let extent = axis(&name, first.and_then(|state| state.unit));
    let period = Axis::new(&timed(info, "period", "s"));
    let mut extents = Chart::new(Panel::new(parameter.clone(), extent));
    let mut periods = Chart::new(Panel::new(parameter, period));
    let largest = |values: &[f64]| values.first().copied().unwrap_or(0.0);
    for one in branch.all() {
        extents.add(
            &points(one, |orbit| largest(&orbit.max_abs)),
            marks(one, |special| largest(&special.max_abs)),
        );
        periods.add(
            &points(one, |orbit| orbit.period),
            marks(one, |special| special.period),
        );
    }
    Figure::new("", info.name, String::new())
        .columns(2)
        .panel(extents.panel())
        .panel(periods.panel())
}

fn points(branch: &BranchRecord, shown: impl Fn(&OrbitRecord) -> f64) -> Vec<Point> {
    let point = |orbit: &OrbitRecord| {
        Some(Point {
            at: [orbit.r?, shown(orbit)],
            beside: orbit.period,
            stability: orbit.floquet.stability,
        })
    };
    branch.points.iter().filter_map(point).collect()
}

fn marks(branch: &BranchRecord, shown: impl Fn(&Special) -> f64) -> Vec<Mark> {
    let mark = |special: &Special| Mark {
        kind: special.kind,
        label: special.label.clone(),
        at: [special.r, shown(special)],
        beside: special.period,
    };
    branch.special.iter().map(mark).collect()
}
