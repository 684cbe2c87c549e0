//! Special points between two points of a branch, located on the branch itself.

use nalgebra::DVector;

use super::special::{Found, Kind, Spot};
use super::{EquilibriumProblem, Spectrum};
use crate::continuation::{Linearisation, ZeroProblem, correct, root, tangent};
use crate::motion::Velocity;

/// Bisections of a step within which every change of stability must be explained.
const DEPTH: usize = 16;

/// A problem, and in what units its branch is measured.
pub(super) struct Locator<'a> {
    pub(super) problem: &'a mut EquilibriumProblem,
    pub(super) r_scale: f64,
    pub(super) accuracy: f64,
}

impl Locator<'_> {
    /// What happens from `a` to `b`, in this order; `Err` with the narrowest stretch over which the stability changes
    /// without a reason that was found.
    pub(super) fn events(&mut self, a: &Spot, b: &Spot) -> Result<Vec<Found>, (f64, f64)> {
        self.search(a, b, DEPTH)
    }

    fn search(&mut self, a: &Spot, b: &Spot, depth: usize) -> Result<Vec<Found>, (f64, f64)> {
        let found = self.crossings(a, b);
        let crossings = found.iter().filter_map(|found| found.kind.crossing());
        let change = a.spectrum.unstable.abs_diff(b.spectrum.unstable);
        if explains(change, &crossings.collect::<Vec<_>>()) {
            return Ok(found);
        }
        let unexplained = (a.r, b.r);
        let middle = (depth > 0).then(|| self.between(a, b, 0.5)).flatten();
        let middle = middle.ok_or(unexplained)?;
        let mut all = self.search(a, &middle, depth - 1)?;
        all.extend(self.search(&middle, b, depth - 1)?);
        Ok(all)
    }

    /// Every kind whose test function changes its sign, located once.
    fn crossings(&mut self, a: &Spot, b: &Spot) -> Vec<Found> {
        let mut found = Vec::new();
        let turns = turns(a, b);
        for kind in [Kind::Fold, Kind::BranchPoint, Kind::Hopf] {
            let there = match kind {
                Kind::Fold => turns,
                Kind::BranchPoint => !turns && changes(a, b, kind),
                _ => changes(a, b, kind),
            };
            if !there {
                continue;
            }
            let spot = self.locate(a, b, kind);
            let neutral = kind == Kind::Hopf && spot.spectrum.critical_frequency().is_none();
            if !neutral {
                found.push(Found { kind, spot });
            }
        }
        found
    }

    /// The zero of the test function of `kind` between `a` and `b`, on different sides of it.
    pub(super) fn locate(&mut self, a: &Spot, b: &Spot, kind: Kind) -> Spot {
        let mut best = if a.test(kind).abs() < b.test(kind).abs() {
            a.clone()
        } else {
            b.clone()
        };
        root(a.test(kind), b.test(kind), |share| {
            let spot = self.between(a, b, share)?;
            let test = spot.test(kind);
            if test.abs() <= best.test(kind).abs() {
                best = spot;
            }
            Some(test)
        });
        best
    }

    /// The point of the branch over this share of the way from `a` to `b`.
    ///
    /// Between points without a fold r itself measures the way: a branch may bend back over its chord.
    fn between(&mut self, a: &Spot, b: &Spot, share: f64) -> Option<Spot> {
        let order = a.state.len();
        let mut normal = DVector::zeros(order + 1);
        normal[order] = (b.r - a.r).signum();
        let straight = !turns(a, b) && a.r != b.r;
        let direct = straight.then(|| self.across(&normal, a, b, share));
        direct
            .flatten()
            .or_else(|| self.across(&self.chord(a, b), a, b, share))
    }

    fn chord(&self, a: &Spot, b: &Spot) -> DVector<f64> {
        let step = (b.unknowns() - a.unknowns()).component_div(&self.problem.scale());
        let order = step.len();
        let mut chord = DVector::zeros(order + 1);
        chord.rows_mut(0, order).copy_from(&step);
        chord[order] = (b.r - a.r) / self.r_scale;
        chord.normalize()
    }

    /// The point of the branch on the plane across `normal` through this share of the chord.
    fn across(&mut self, normal: &DVector<f64>, a: &Spot, b: &Spot, share: f64) -> Option<Spot> {
        let (from, to) = (a.unknowns(), b.unknowns());
        let z = &from + (&to - &from) * share;
        let r = a.r + (b.r - a.r) * share;
        let scale = self.problem.scale();
        let there = correct(self.problem, z, r, normal, self.r_scale, self.accuracy).ok()?;
        let along = tangent(&there.linearisation, &scale, self.r_scale, normal)?;
        self.spot(&there.z, there.r, &there.linearisation, along[scale.len()])
    }

    fn spot(
        &self,
        z: &DVector<f64>,
        r: f64,
        at: &Linearisation<Velocity>,
        tangent_r: f64,
    ) -> Option<Spot> {
        spot(self.problem, z, r, &at.extra, tangent_r, at.residual.norm())
    }
}

/// A converged point with all that is told of it.
pub(super) fn spot(
    problem: &EquilibriumProblem,
    z: &DVector<f64>,
    r: f64,
    velocity: &Velocity,
    tangent_r: f64,
    residual: f64,
) -> Option<Spot> {
    let place = problem.place(z);
    Some(Spot {
        spectrum: Spectrum::of(&velocity.jacobian),
        residual,
        margins: problem.family.at(r).ok()?.margins(&place),
        state: place.state,
        r,
        tangent_r,
        determinant: Spot::determinant_of(&velocity.jacobian),
    })
}

fn changes(a: &Spot, b: &Spot, kind: Kind) -> bool {
    (a.test(kind) >= 0.0) != (b.test(kind) >= 0.0)
}

/// Whether the branch turns: at a sharp corner the tangent alone may point backwards, but no eigenvalue passes zero.
fn turns(a: &Spot, b: &Spot) -> bool {
    changes(a, b, Kind::Fold) && changes(a, b, Kind::BranchPoint)
}

/// Whether crossings by these numbers, each up or down, can add up to the change.
fn explains(change: usize, crossings: &[usize]) -> bool {
    let total: usize = crossings.iter().sum();
    change <= total && (total - change).is_multiple_of(2)
}
