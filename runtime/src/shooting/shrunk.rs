//! The Hopf point of an equilibrium onto which orbits have shrunk.

use std::f64::consts::TAU;
use std::ops::ControlFlow;

use super::orbit::Orbit;
use crate::continuation::{Kind, Located};
use crate::equilibrium::{EquilibriumPoint, follow, settings, settle};
use crate::motion::Family;

/// How far beyond the last orbit the equilibrium is followed: relative to r, and in steps of the branch.
const BEYOND: f64 = 1e-3;
const STEPS: f64 = 4.0;
/// Relative difference of two frequencies that are one: that of so small an orbit differs with the square of its size.
const SAME: f64 = 1e-3;

/// The Hopf point onto which these orbits have shrunk: the nearest on the branch of the equilibrium that has their
/// frequency, located as any other of that branch.
pub(super) fn shrunk(family: &Family, orbits: &[Orbit]) -> Option<Located<Orbit>> {
    let [.., before, last] = orbits else {
        return None;
    };
    let step = STEPS * (last.r - before.r).abs();
    let reach = step.max(BEYOND * last.r.abs());
    let settings = settings(last.r - reach, last.r + reach);
    let from = settle(family, settings.from, &last.place)?.place;
    let (walked, _) = follow(family, &from, settings, &mut |_| ControlFlow::Continue(())).ok()?;
    let off = |at: &Located<EquilibriumPoint>| (at.r - last.r).abs();
    let here = |at: &Located<EquilibriumPoint>| {
        let turn = at.point.frequency().map(|turn| turn * last.period / TAU);
        at.kind == Kind::Hopf && turn.is_some_and(|turn| (turn - 1.0).abs() <= SAME)
    };
    let all = walked.located.into_iter().filter(here);
    let found = all.min_by(|a, b| off(a).total_cmp(&off(b)))?;
    let mut orbit = last.clone();
    orbit.r = found.r;
    orbit.period = TAU / found.point.frequency()?;
    orbit.place.state.clone_from(&found.point.state);
    (orbit.min, orbit.max) = (found.point.state.clone(), found.point.state);
    orbit.section = vec![orbit.place.state.clone()];
    let mut met = Located::at(Kind::Hopf, found.r, orbit);
    (met.error, met.last) = (found.error, true);
    Some(met)
}
