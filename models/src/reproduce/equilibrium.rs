//! Equilibria of smooth copies: stable where the real one is not, or the other way round.

use stickslip::bifurcation::Stability;
use stickslip::report::{Curve, Marker};
use stickslip::study::EquilibriaRecord;

use super::pieces::{Directed, UNKNOWN, directed, pieces};

/// Series of stable equilibria: a solid line; of unstable ones: a dashed line; of Hopf points; of the exact system.
const STABLE: usize = 6;
const UNSTABLE: usize = 1;
const HOPF: usize = 2;
const EXACT: usize = 3;

/// The Hopf points of a branch, with their first state.
fn points(branch: &EquilibriaRecord) -> Vec<[f64; 2]> {
    let special = branch.special.iter();
    let hopf = special.filter(|point| point.period.is_some());
    hopf.map(|point| [point.r, point.state[0]]).collect()
}

/// Where the first Hopf points of a branch are.
pub(super) fn hopf<const K: usize>(branch: &EquilibriaRecord) -> [f64; K] {
    let points = points(branch);
    std::array::from_fn(|i| points.get(i).map_or(f64::NAN, |point| point[0]))
}

/// The equilibria of a copy with its Hopf points, and those of the exact system.
pub(super) fn drawn(
    (copy, artefacts): (&EquilibriaRecord, &str),
    (exact, label): (&EquilibriaRecord, &str),
) -> Vec<Curve> {
    let stretches = pieces(&curve(copy)).into_iter().map(|(stable, points)| {
        let (label, series) = match stable {
            true => ("copy, stable", STABLE),
            false => ("copy, unstable", UNSTABLE),
        };
        directed(label, series, points)
    });
    let exact = curve(exact).into_iter().map(|(_, point)| point).collect();
    let hopf = Curve::points(artefacts, HOPF, Marker::Diamond, points(copy));
    let others = [hopf, directed(label, EXACT, exact)];
    stretches.chain(others).collect()
}

/// The first state along a branch, with the stability from there on.
fn curve(branch: &EquilibriaRecord) -> Vec<(bool, Directed)> {
    let mut curve: Vec<(bool, Directed)> = Vec::new();
    let mut special = points(branch).into_iter();
    for found in &branch.points {
        let stable = found.stability == Stability::Stable;
        if curve.last().is_some_and(|(before, _)| *before != stable) {
            curve.extend(special.next().map(|change| (stable, (change, UNKNOWN))));
        }
        let at = [found.r.unwrap_or(f64::NAN), found.state[0]];
        let beside = found.beside.as_ref();
        let way = beside.map_or(UNKNOWN, |(r, state)| [r - at[0], state[0] - at[1]]);
        curve.push((stable, (at, way)));
    }
    curve
}
