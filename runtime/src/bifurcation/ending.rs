//! Why a branch goes no further.

use super::Kind;
use super::monitors::stays_off;
use super::periodic::PeriodicPoint;
use crate::continuation::Located;
use crate::math::{at_zero, line};

/// Points that are looked at.
const POINTS: usize = 8;
/// How much more the period changes than r, both relative, where a branch stands upright.
const UPRIGHT: f64 = 1e3;

/// Halves of an orbit that differ by no more than this, and ever less, are about to become one.
const CLOSING: f64 = 0.05;
/// How much the squares by which they differ are apart from each other, and among how many points such are sought.
const APART: f64 = 1.5;
const LOOKED: usize = 40;
/// How much the least of them may be below the last, which is one as far as its digits tell.
const NOISE: f64 = 100.0;
/// What the errors of these points may add up to in the end, over one of them.
const WEIGHT: f64 = 10.0;
/// What is reported over what two extrapolations differ by.
const DOUBT: f64 = 2.0;

/// The bifurcation that ends a branch after these points, if they point to one: where a doubled orbit meets the one that
/// it doubles, or where r no longer changes while the orbit does, so that the branch turns, however sharply.
pub fn explain<P: PeriodicPoint>(points: &[P], accuracy: f64) -> Option<Located<P>> {
    let last = &points[points.len().saturating_sub(POINTS)..];
    meeting(points, accuracy).or_else(|| turning(last, accuracy))
}

/// Where both halves of an orbit become one: r is a smooth function of the square by which they differ. The last points
/// may be one as far as their digits tell, so that only those are compared that differ by more than these.
fn meeting<P: PeriodicPoint>(points: &[P], accuracy: f64) -> Option<Located<P>> {
    let seen = |point: &P| (point.asymmetry().powi(2), point.r());
    let looked = || points.iter().rev().map(seen).take(LOOKED);
    let mut earlier = looked();
    let (z, r) = earlier.next()?;
    let (y, q) = earlier.find(|(square, _)| *square >= APART * z)?;
    let (x, p) = earlier.find(|(square, _)| *square >= APART * y)?;
    let least = looked().fold(f64::INFINITY, |least, (square, _)| least.min(square));
    let found = at_zero([(x, p), (y, q), (z, r)]);
    let (at, near) = (found.value, found.lines[0]);
    let closes = z <= CLOSING * CLOSING && z <= NOISE * least;
    (closes && at.is_finite()).then(|| {
        let error = DOUBT * (at - near).abs() + WEIGHT * accuracy * at.abs();
        let mut met = Located::at(Kind::Flip, at, points[points.len() - 1].clone());
        (met.error, met.last) = (error, true);
        met
    })
}

/// The same where the next orbit was the one that is gone around twice, so that two points suffice: on a border halves differ
/// by as much as r is away from it, in a flip by the root of that, and what both say is what is known.
pub fn falls<P: PeriodicPoint>(points: &[P], accuracy: f64) -> Option<Located<P>> {
    let seen = |point: &P| (point.asymmetry(), point.r());
    let last = points.last()?;
    let near = seen(last);
    let mut earlier = points.iter().rev().map(seen);
    let far = earlier.find(|(size, _)| *size >= APART.sqrt() * near.0)?;
    let zero = |power: i32| {
        let [far, near] = [far, near].map(|(size, r)| (size.powi(power), r));
        line(far, near)
    };
    let (at, other) = (zero(2), zero(1));
    (near.0 <= CLOSING && at.is_finite() && other.is_finite()).then(|| {
        let mut met = Located::at(Kind::Flip, at, last.clone());
        met.error = DOUBT * (at - other).abs() + WEIGHT * accuracy * at.abs();
        met.last = true;
        met
    })
}

/// Where r stands still while the period goes on changing.
fn turning<P: PeriodicPoint>(points: &[P], accuracy: f64) -> Option<Located<P>> {
    if points.len() < POINTS {
        return None;
    }
    let spread = |value: fn(&P) -> f64| {
        let values = || points.iter().map(value);
        let (low, high) = (
            values().fold(f64::INFINITY, f64::min),
            values().fold(f64::NEG_INFINITY, f64::max),
        );
        (high - low) / high.abs().max(low.abs())
    };
    let (still, moving) = (spread(P::r), spread(P::period));
    // Along a canard r stands still as well, and turns nowhere.
    let turns = points.iter().any(|point| !stays_off([&points[0], point]));
    if still > 10.0 * accuracy || moving < UPRIGHT * still || !turns {
        return None;
    }
    let mut values: Vec<f64> = points.iter().map(P::r).collect();
    values.sort_by(f64::total_cmp);
    let (low, high) = (values[0], values[values.len() - 1]);
    let mut turns = Located::at(Kind::Fold, values[values.len() / 2], points.last()?.clone());
    turns.error = high - low + WEIGHT * accuracy * high.abs().max(low.abs());
    Some(turns)
}
