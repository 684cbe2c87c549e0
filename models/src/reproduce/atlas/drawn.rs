//! Figures 3.15, 3.17 and 3.18 of the thesis as they are printed: stable and unstable orbits.

use std::collections::HashSet;

use stickslip::bifurcation::Stability;
use stickslip::report::{Axis, Curve, Marker, Panel};
use stickslip::study::OrbitRecord;

use super::super::pieces::pieces;
use super::{Atlas, RANGE};

/// Of points that print as one, one is drawn.
const CELL: [f64; 2] = [1e-3, 1e-2];

/// Two panels in which each branch is a curve of this quantity.
pub(super) fn panels(atlases: [&Atlas; 2], label: &str, of: fn(&OrbitRecord) -> f64) -> [Panel; 2] {
    atlases.map(|atlas| panel(atlas, label).curves(curves(atlas, of)))
}

fn panel(atlas: &Atlas, label: &str) -> Panel {
    let speed = Axis::new("*V*_{dr}").from(RANGE[0], RANGE[1]);
    Panel::new(speed, Axis::new(label)).titled(atlas.title())
}

/// The Poincaré points are no curves: one marker each.
pub(super) fn points(atlas: &Atlas) -> Panel {
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
    panel(atlas, "*X*_{1} where *X*_{1}′ = 0").curves([
        Curve::points("unstable ", 1, Marker::Cross, unstable),
        Curve::points("stable ", 0, Marker::Circle, stable),
    ])
}

fn stable(point: &OrbitRecord) -> bool {
    point.floquet.stability == Stability::Stable
}

/// Pieces of all branches, each of one stability and up to the next one.
fn curves(atlas: &Atlas, of: fn(&OrbitRecord) -> f64) -> Vec<Curve> {
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
