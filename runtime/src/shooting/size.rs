//! How large orbits are beside the largest of their branch, and whether smaller ones shrink to a Hopf point as its normal form
//! says.

use std::f64::consts::TAU;
use std::ops::ControlFlow;

use crate::continuation::{Kind, Located};
use crate::equilibrium::{EquilibriumPoint, follow, settings, settle};
use crate::motion::{Family, Place};

/// How far beyond the last orbit the equilibrium is followed: relative to r, and in steps of the branch.
const BEYOND: f64 = 1e-3;
const STEPS: f64 = 4.0;
/// Relative difference of two frequencies that are one: that of a small orbit differs with the square of its size.
const SAME: f64 = 1e-2;

/// Orbits this small, as a share of the largest on their branch, are looked at whether they shrink as Hopf's normal form says.
const SMALL: f64 = 1e-2;
/// How far off the Hopf point may be from where the normal form sees it, as a share of its distance.
const OFF: f64 = 0.05;

/// An orbit of a branch: its design variable and its size, as a share of the largest on the branch.
#[derive(Debug, Clone, Copy)]
pub(super) struct Size {
    pub(super) r: f64,
    pub(super) share: f64,
}

impl Size {
    /// Whether between this orbit and a Hopf point there are only such orbits as Hopf's normal form has: their squares fall
    /// with r, from the orbit before to this one, and to zero at the Hopf point of the equilibrium within. Orbits smaller
    /// than that tell nothing more: 1 − μ falls with the square, too, until it is noise. Of orbits r is `known` with this error.
    pub(super) fn vanishes(
        self,
        before: Self,
        family: &Family,
        (place, period): (&Place, f64),
        known: f64,
    ) -> bool {
        if self.share > SMALL || self.share >= before.share {
            return false;
        }
        let [here, there] = [self, before].map(|size| size.share * size.share);
        let seen = self.r - here * (self.r - before.r) / (here - there);
        let step = (self.r - before.r).abs();
        let found = hopf(family, (self.r, step), (place, period));
        found.is_some_and(|at| (at.r - seen).abs() <= OFF * (at.r - before.r).abs() + known)
    }
}

/// The Hopf point nearest to r on the branch of the equilibrium within a small orbit that has its frequency, located as any
/// other of that branch.
pub(super) fn hopf(
    family: &Family,
    (r, step): (f64, f64),
    (place, period): (&Place, f64),
) -> Option<Located<EquilibriumPoint>> {
    let reach = (STEPS * step).max(BEYOND * r.abs());
    let settings = settings(r - reach, r + reach);
    let from = settle(family, settings.from, place)?.place;
    let (walked, _) = follow(family, &from, settings, &mut |_| ControlFlow::Continue(())).ok()?;
    let off = |at: &Located<EquilibriumPoint>| (at.r - r).abs();
    let here = |at: &Located<EquilibriumPoint>| {
        let turn = at.point.frequency().map(|turn| turn * period / TAU);
        at.kind == Kind::Hopf && turn.is_some_and(|turn| (turn - 1.0).abs() <= SAME)
    };
    let all = walked.located.into_iter().filter(here);
    all.min_by(|a, b| off(a).total_cmp(&off(b)))
}
