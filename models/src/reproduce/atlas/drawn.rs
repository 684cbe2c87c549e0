//! Figures 3.15, 3.17 and 3.18 of the thesis as they are printed: stable and unstable orbits.

use std::collections::HashSet;

use stickslip::bifurcation::Stability;
use stickslip::report::{Axis, Curve, Figure, Marker, Panel};
use stickslip::study::OrbitRecord;

use super::super::pieces::pieces;
use super::{Atlas, RANGE};

/// Of points that print as one, one is drawn.
const CELL: [f64; 2] = [1e-3, 1e-2];

/// What is drawn of an orbit.
type Quantity = fn(&OrbitRecord) -> f64;

pub(super) fn figures(smoothed: &Atlas, exact: &Atlas) -> Vec<Figure> {
    let both = |number: &str, title: &str, caption: &str, label: &str, of: Quantity| {
        let figure = Figure::new(number, title, caption).columns(2);
        [smoothed, exact].iter().fold(figure, |figure, atlas| {
            let axis = Axis::new("*V*_{dr}").from(RANGE[0], RANGE[1]);
            let panel = Panel::new(axis, Axis::new(label)).titled(atlas.title());
            figure.panel(panel.curves(curves(atlas, of)))
        })
    };
    vec![
        both(
            "3.15",
            "Free frequency",
            "Frequency of the periodic orbits over the speed of the belt.",
            "*f*",
            |orbit| 1.0 / orbit.period,
        ),
        both(
            "3.17",
            "Absolute maximum of X₁",
            "Largest displacement of the first mass over the speed of the belt. The interactive page enlarges it, as \
             Fig. 3.16 does.",
            "max |*X*_{1}|",
            |orbit| orbit.max_abs[0],
        ),
        points(smoothed, exact),
    ]
}

/// The Poincaré points are no curves: one marker each.
fn points(smoothed: &Atlas, exact: &Atlas) -> Figure {
    let caption = "The displacement of the first mass where its velocity passes zero upwards, for all orbits.";
    let figure = Figure::new("3.18", "Bifurcation diagram", caption).columns(2);
    [smoothed, exact].iter().fold(figure, |figure, atlas| {
        let mut all = [Vec::new(), Vec::new()];
        let mut taken = HashSet::new();
        for point in atlas.branches().flat_map(|(_, branch)| &branch.points) {
            let (Some(r), kind) = (point.r, usize::from(!stable(point))) else {
                continue;
            };
            let values = point.section.iter().map(|state| [r, state[0]]);
            all[kind].extend(values.filter(|[x, y]| {
                taken.insert(((x / CELL[0]).round() as i64, (y / CELL[1]).round() as i64))
            }));
        }
        let [stable, unstable] = all;
        let axis = Axis::new("*V*_{dr}").from(RANGE[0], RANGE[1]);
        let panel = Panel::new(axis, Axis::new("*X*_{1} where *X*_{1}′ = 0")).titled(atlas.title());
        figure.panel(panel.curves([
            Curve::points("unstable ", 1, Marker::Cross, unstable),
            Curve::points("stable ", 0, Marker::Circle, stable),
        ]))
    })
}

fn stable(point: &OrbitRecord) -> bool {
    point.floquet.stability == Stability::Stable
}

/// Pieces of all branches, each of one stability and up to the next one.
fn curves(atlas: &Atlas, of: Quantity) -> Vec<Curve> {
    let pieces = atlas.branches().flat_map(|(_, branch)| {
        let orbits = branch.points.iter();
        let curve = orbits.filter_map(|orbit| Some((stable(orbit), [orbit.r?, of(orbit)])));
        pieces(&curve.collect::<Vec<_>>())
    });
    pieces
        .map(|(stable, points)| {
            let (label, series) = if stable {
                ("stable", 0)
            } else {
                ("unstable", 1)
            };
            Curve::line(label, series, points)
        })
        .collect()
}
