//! Figures 3.15, 3.17 and 3.18 of the thesis as they are printed: stable and unstable orbits.

use stickslip::bifurcation::Stability;
use stickslip::report::chart::{Chart, Drawn};
use stickslip::report::{Axis, Curve, Panel};
use stickslip::study::{BranchRecord, OrbitRecord, Special};

use super::super::pieces::pieces;
use super::{Atlas, RANGE};

/// Points of neighbouring orbits further apart than this are no curve.
const APART: f64 = 0.1;

/// A quantity of orbits, and of special points.
pub(super) type Quantity = (fn(&OrbitRecord) -> f64, fn(&Special) -> f64);

/// Two panels in which each branch is a curve of this quantity.
pub(super) fn panels(atlases: [&Atlas; 2], label: &str, quantity: Quantity) -> [Panel; 2] {
    atlases.map(|atlas| curves(atlas, label, quantity))
}

fn panel(atlas: &Atlas, label: &str) -> Panel {
    let speed = Axis::new("*V*_{dr}").from(RANGE[0], RANGE[1]);
    Panel::new(speed, Axis::new(label)).titled(atlas.title())
}

/// All branches, each of one stability up to the next, and from where it leaves another; the table names the special
/// points.
fn curves(atlas: &Atlas, label: &str, (of, special): Quantity) -> Panel {
    let mut chart = Chart::new(panel(atlas, label));
    for (_, branch) in atlas.branches() {
        let mut drawn = Drawn::of((0, branch), |orbit| Some(of(orbit)), special);
        // So many markers would hide the branches.
        drawn.marks.iter_mut().for_each(|mark| mark.shown = false);
        chart.add(drawn);
    }
    chart.panel()
}

/// The Poincaré points: as many curves for each branch as its orbits have points.
pub(super) fn points(atlas: &Atlas) -> Panel {
    let strands = atlas.branches().flat_map(|(_, branch)| strands(branch));
    let pieces = strands.flat_map(|strand| pieces(&strand));
    let curve = |(stable, points): (bool, Vec<[f64; 2]>)| match stable {
        true => Curve::smooth("stable", 0, points),
        false => Curve::smooth("unstable", 1, points),
    };
    panel(atlas, "*X*_{1} where *X*_{1}′ = 0").curves(pieces.map(curve))
}

type Strand = Vec<(bool, [f64; 2])>;

/// The points of the orbits of a branch, joined to those next to them of the next orbit.
fn strands(branch: &BranchRecord) -> Vec<Strand> {
    let (mut done, mut open): (Vec<Strand>, Vec<Strand>) = (Vec::new(), Vec::new());
    for orbit in &branch.points {
        let stable = orbit.floquet.stability == Stability::Stable;
        let r = orbit.r.unwrap_or(f64::NAN);
        let mut values: Vec<f64> = orbit.section.iter().map(|state| state[0]).collect();
        let mut next = Vec::new();
        for mut strand in std::mem::take(&mut open) {
            let last = strand.last().map_or(f64::NAN, |(_, at)| at[1]);
            let off = |value: &f64| (value - last).abs();
            let found =
                (0..values.len()).min_by(|&i, &j| off(&values[i]).total_cmp(&off(&values[j])));
            match found.filter(|&i| off(&values[i]) < APART) {
                Some(i) => {
                    strand.push((stable, [r, values.swap_remove(i)]));
                    next.push(strand);
                }
                None => done.push(strand),
            }
        }
        next.extend(values.into_iter().map(|value| vec![(stable, [r, value])]));
        open = next;
    }
    done.extend(open);
    done
}
