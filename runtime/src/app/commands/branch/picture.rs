//! A branch, with those that leave it, as a figure.

use std::f64::consts::TAU;

use super::arguments::Shown;
use crate::app::chart::{Chart, Mark, Point, along_axis, axis};
use crate::app::harmonics::{harmonic, names};
use crate::app::text::timed;
use crate::model::ModelInfo;
use crate::report::{Axis, Figure, Panel};
use crate::study::{BranchRecord, OrbitRecord, Special};

/// The extent of the states that are shown, and the period; amplitudes and phases, each pair in a row.
pub(super) fn picture(info: &ModelInfo, branch: &BranchRecord, shown: &Shown) -> Figure {
    let extents = shown.states.iter().map(|&j| extent(info, branch, j));
    let mut panels: Vec<Panel> = extents.collect();
    let odd = panels.len() % 2 == 1;
    if odd {
        panels.push(period(info, branch));
    }
    for &j in &shown.states {
        let pairs = shown
            .orders
            .iter()
            .map(|&order| response(info, branch, order, j));
        panels.extend(pairs.flatten());
    }
    if !odd {
        panels.push(period(info, branch));
    }
    let figure = Figure::new("", info.name, String::new()).columns(2);
    panels.into_iter().fold(figure, Figure::panel)
}

fn period(info: &ModelInfo, branch: &BranchRecord) -> Panel {
    let period = Axis::new(&timed(info, "period", "s"));
    let mut periods = Chart::new(Panel::new(along_axis(info, &branch.along), period));
    for one in branch.all() {
        periods.add(
            &points(one, |orbit| Some(orbit.period)),
            marks(one, |special| special.period),
        );
    }
    periods.panel()
}

fn extent(info: &ModelInfo, branch: &BranchRecord, j: usize) -> Panel {
    let state = info.states.get(j);
    let name = format!("max |{}|", state.map_or("", |state| state.name));
    let extent = axis(&name, state.and_then(|state| state.unit));
    let mut extents = Chart::new(Panel::new(along_axis(info, &branch.along), extent));
    for one in branch.all() {
        extents.add(
            &points(one, |orbit| orbit.max_abs.get(j).copied()),
            marks(one, |special| {
                special.max_abs.get(j).copied().unwrap_or(0.0)
            }),
        );
    }
    extents.panel()
}

/// Amplitude and phase of a state at a harmonic.
fn response(info: &ModelInfo, branch: &BranchRecord, order: usize, j: usize) -> [Panel; 2] {
    let [mut amplitudes, mut phases] = names(info, order, j).map(|name| {
        Chart::new(Panel::new(
            along_axis(info, &branch.along),
            Axis::new(&name),
        ))
    });
    for one in branch.all() {
        let amplitude = |orbit: &OrbitRecord| Some(harmonic(orbit, order)?.amplitude[j]);
        let mut before = None;
        let phase = |orbit: &OrbitRecord| {
            let known = harmonic(orbit, order)?;
            let certain = known.amplitude[j] > known.error[j];
            let next = certain.then(|| unwrapped(known.phase[j], before))?;
            before = Some(next);
            before
        };
        amplitudes.add(&points(one, amplitude), Vec::new());
        phases.add(&points(one, phase), Vec::new());
    }
    [amplitudes.panel(), phases.panel()]
}

/// A phase, so many turns away that it goes on from the one before.
fn unwrapped(phase: f64, before: Option<f64>) -> f64 {
    let before = before.unwrap_or(phase);
    phase + ((before - phase) / TAU).round() * TAU
}

fn points(branch: &BranchRecord, mut shown: impl FnMut(&OrbitRecord) -> Option<f64>) -> Vec<Point> {
    let point = |orbit: &OrbitRecord| {
        Some(Point {
            at: [orbit.r?, shown(orbit)?],
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
