//! Whether orbits come to a border at which the motion jumps: beyond it there are none that could tell.
//!
//! Where several events vanish at once, as in both halves of an orbit that mirror each other, an orbit on the border of one of
//! them may leave the other out: it solves all equations, but no orbit with both of them comes near to it.

use crate::motion::{Family, apart};
use crate::shooting::converge::converge;
use crate::shooting::grip::near;
use crate::shooting::orbit::Orbit;

/// Share of the way to the border at which an orbit is looked at, and of the last distance within which it is to be.
const SHARE: f64 = 1e-3;
const NEARER: f64 = 0.05;

/// Whether the orbit shortly before a border is so much nearer to it than the last one; so it is taken to be where there is
/// none that could be told from others, and of what runs on.
pub(super) fn comes_there(family: &Family, last: &Orbit, border: &Orbit, accuracy: f64) -> bool {
    if border.shift.is_some() {
        return true;
    }
    let r = border.r + SHARE * (last.r - border.r);
    let Ok(before) = converge(family, r, &last.guess(), &near(last, accuracy)) else {
        return true;
    };
    let units = last.magnitude();
    let off = |orbit: &Orbit| {
        let points = border.section.iter().chain([&border.place.state]);
        let off = points.map(|point| apart(&orbit.place.state, point, &units));
        off.fold(f64::INFINITY, f64::min)
    };
    let errors = last.error_estimate.max(before.error_estimate) / last.floquet.pull();
    !before.has_word_of(last, 1) || off(&before) <= (NEARER * off(last)).max(errors)
}
