//! Orbits that a branch has come by before: next to a fold, those on the way there are near to those that follow.

use super::converge::converge;
use super::orbit::Orbit;
use super::same::SAME_ORBIT;
use super::sought::Search;
use crate::bifurcation::test_function::fold;
use crate::continuation::{Watched, changes};
use crate::motion::Family;

/// Share of the distance to where r turned up to which two orbits are one: the nearer that is, the nearer are those on both
/// sides of it.
const NEAR: f64 = 0.01;

/// Whether the branch that has come by these orbits, and has turned or would turn, would walk back with this one.
pub(super) fn walks_back(family: &Family, orbits: &[Orbit], orbit: &Orbit, accuracy: f64) -> bool {
    let Some((ends, turn)) = passed(orbits, orbit) else {
        return false;
    };
    let certain = |one: &Orbit| one.marginal() == Some(0);
    // On both sides of a fold this has other signs.
    let side = |one: &Orbit| fold(&one.floquet.multipliers);
    let alike = |end: &&Orbit| {
        let stable = certain(end) && end.unstable() == orbit.unstable();
        stable && !changes(side(end), side(orbit)) && end.seems_in_regime_of(orbit)
    };
    if !certain(orbit) || !ends.iter().any(alike) || !orbit.is_between(ends, 0.0) {
        return false;
    }
    // Next to a corner, Newton's method comes from those before it to those beyond.
    if turn.parts([ends[0], orbit]) {
        return false;
    }
    // From between them: from one of them Newton's method may come to an orbit of another regime that is as near.
    let share = (orbit.r - ends[0].r) / (ends[1].r - ends[0].r);
    let [first, second] = ends.map(Orbit::guess);
    let guess = match share.is_finite() {
        true => first.towards(&second, share),
        false => first,
    };
    let search = Search {
        start: guess.place.state.clone(),
        modes: guess.place.modes.clone(),
        period: Some(guess.period),
        accuracy,
        segments: 1,
    };
    let tolerance = SAME_ORBIT.min(NEAR * turn.apart(orbit));
    let earlier = converge(family, orbit.r, &guess, &search);
    earlier.is_ok_and(|earlier| earlier.coincides(orbit, tolerance))
}

/// The neighbours that r passed this orbit's value between on the way to where it turned last, and the orbit there.
fn passed<'a>(orbits: &'a [Orbit], orbit: &Orbit) -> Option<([&'a Orbit; 2], &'a Orbit)> {
    let slope = |i: usize| orbits.get(i).unwrap_or(orbit).slope();
    let turns = |i: &usize| changes(slope(i - 1), slope(*i));
    let turn = (1..=orbits.len()).rev().find(turns)?;
    let begun = (1..turn).rev().find(turns).unwrap_or(0);
    let r = orbit.r;
    let passes = |pair: &&[Orbit]| (pair[0].r - r) * (pair[1].r - r) <= 0.0;
    let pair = orbits[begun..turn].windows(2).rev().find(passes)?;
    Some(([&pair[0], &pair[1]], orbits.get(turn).or(orbits.last())?))
}
