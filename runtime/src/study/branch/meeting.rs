//! Where a doubled orbit meets the one that it doubles: a flip of that one, or a border on which that doubles.

use crate::bifurcation::test_function::flip;
use crate::continuation::{Located, SETTLED, Watched};
use crate::shooting::{Guess, Orbit, Search, converge, doubles};
use crate::study::orbit::Sought;

/// Distance of the first two orbits between which the flip is sought, relative to r.
const STEP: f64 = 1e-6;
/// Secants until it must be found.
const SECANTS: usize = 8;
/// Distance at which what is zero at a flip grows with it, over the accuracy.
const WAY: f64 = 1e3;
/// Distance, relative to r, beyond which a flip is another one.
const NEAR: f64 = 1e-3;
/// Share of the accuracy at which it is found once more, and what is reported over what both differ by.
const AGAIN: f64 = 0.1;
const DOUBT: f64 = 2.0;

/// Replaces a doubled orbit that has met the one from which it branches by that one, and r by the one at which a
/// multiplier of that is −1, or passes −1 in a jump. Where no such is found, r is where orbits that end at `last` lead to,
/// known to no more than what they were followed to.
pub(super) fn undouble(sought: &Sought<'_>, met: &mut Located<Orbit>, last: Option<f64>) {
    let orbit = &met.point;
    let guess = Guess {
        division: None,
        ..orbit.guess().part(2)
    };
    (met.turns, met.lasting) = (2, f64::NAN);
    let ahead = last.map_or(0.0, |last| (met.r - last).abs());
    match converge(&sought.family, met.r, &guess, &sought.search) {
        Ok(single) if single.period < 0.75 * orbit.period => {
            let size = met.point.r_size();
            let near = |r: f64| (r - met.r).abs() <= NEAR * size;
            let flips = flips(sought, met.r, &single).filter(|flip| near(flip.r));
            let jumps = || {
                let found = doubles(&sought.family, &single, sought.search.accuracy);
                found.filter(|border| near(border.r))
            };
            if let Some(flip) = flips {
                (met.r, met.error, met.point) = (flip.r, flip.error, flip.orbit);
            } else if let Some(border) = jumps() {
                (met.kind, met.r, met.error) = (border.kind, border.r, border.error);
                met.point = border.point;
            } else {
                (met.point, met.error) = (single, met.error.max(ahead));
            }
        }
        // As far as it is known, the doubled orbit is that orbit twice.
        _ => {
            met.error = met.error.max(ahead);
            met.point.period *= 0.5;
            let half = met.point.section.len() / 2;
            met.point.section.truncate(half);
            met.point.period_count = half;
        }
    }
}

/// A flip: where, to what error, and of which orbit.
struct Flip {
    r: f64,
    error: f64,
    orbit: Orbit,
}

/// The flip next to the orbit at r.
fn flips(sought: &Sought<'_>, r: f64, orbit: &Orbit) -> Option<Flip> {
    let accuracy = sought.search.accuracy;
    let at = |r: f64, near: &Orbit, share: f64| {
        let search = Search {
            accuracy: share * accuracy,
            ..sought.search.clone()
        };
        converge(&sought.family, r, &near.guess(), &search).ok()
    };
    let test = |orbit: &Orbit| flip(&orbit.floquet.multipliers);
    let r_size = orbit.r_size();
    let (mut last, mut next) = ((r, test(orbit)), r + STEP * r_size);
    let mut orbit = orbit.clone();
    for _ in 0..SECANTS {
        orbit = at(next, &orbit, 1.0)?;
        let value = test(&orbit);
        let slope = (value - last.1) / (next - last.0);
        let step = -value / slope;
        if !step.is_finite() {
            return None;
        }
        let r = next + step;
        if step.abs() <= accuracy * r_size {
            let sharper = at(r, &orbit, AGAIN)?;
            let off = (test(&sharper) / slope).abs();
            let error = DOUBT * off + SETTLED * accuracy * r_size;
            let beside = |way: f64| Some(test(&at(r + way, &orbit, 1.0)?));
            let way = (WAY * accuracy).clamp(STEP, NEAR) * r_size;
            return passes(beside, way).then_some(Flip { r, error, orbit });
        }
        (last, next) = ((next, value), r);
    }
    None
}

/// Whether what is zero at a place grows with the distance from it, to one side at least: where a multiplier jumps past −1, secants
/// settle as well, and it does not.
fn passes(beside: impl Fn(f64) -> Option<f64>, way: f64) -> bool {
    let grows = |way: f64| {
        let [half, whole] = [beside(0.5 * way)?, beside(way)?];
        Some((whole - 2.0 * half).abs() <= 0.5 * whole.abs())
    };
    [way, -way].into_iter().any(|way| grows(way) == Some(true))
}
