//! Where r stands still while the orbits of a branch go on changing.

use super::orbit::Orbit;
use crate::continuation::Watched;

/// Orbits in a row by which it is told.
const MANY: usize = 20;
/// Errors of an orbit by which a multiplier is off from 1 at most.
const MARGIN: f64 = 10.0;
/// How far orbits go on changing, over the root of their accuracy: as far as that r stands still at a pitchfork, too.
const WIDE: f64 = 10.0;

/// The value of r at which these orbits, the last of which have one r and a multiplier 1 as far as their accuracy tells, are
/// a family: each is as good as the others, and a branch would go on among them for ever. At a fold r stands still as well,
/// and along a canard, but not with a multiplier 1 all along.
pub(super) fn stands_still(orbits: &[Orbit], accuracy: f64) -> Option<f64> {
    let last = orbits.last()?;
    let stays = |orbit: &&Orbit| {
        let still = (orbit.r - last.r).abs() <= accuracy * last.r_scale();
        let marginal = || orbit.floquet.pull() <= MARGIN * accuracy;
        still && (marginal() || orbit.floquet.may_be_one())
    };
    let many = orbits.iter().rev().take_while(stays).count();
    let first = orbits.get(orbits.len() - many).filter(|_| many >= MANY)?;
    let zero = last.r.abs() <= accuracy * last.r_scale();
    let r = if zero { 0.0 } else { last.r };
    (last.apart(first) > WIDE * accuracy.sqrt()).then_some(r)
}
