//! Why a branch goes no further.

use super::Kind;
use super::periodic::PeriodicPoint;
use crate::continuation::Located;

/// Points that are looked at.
const POINTS: usize = 8;
/// How much more the period changes than r, both relative, where a branch stands upright.
const UPRIGHT: f64 = 1e3;

/// Halves of an orbit that differ by no more than this, and ever less, are about to become one.
const CLOSING: f64 = 0.05;
/// How far that may be extrapolated, in steps of the square by which they differ.
const STEPS: f64 = 30.0;
/// What is reported over what two extrapolations differ by.
const DOUBT: f64 = 2.0;

/// The bifurcation that ends a branch after these points, if they point to one: where a doubled orbit meets the one that
/// it doubles, or where r no longer changes while the orbit does, so that the branch turns, however sharply.
pub fn explain<P: PeriodicPoint>(points: &[P], accuracy: f64) -> Option<Located<P>> {
    let last = &points[points.len().saturating_sub(POINTS)..];
    meeting(last, accuracy).or_else(|| turning(last, accuracy))
}

/// Where both halves of an orbit become one: r is a smooth function of the square by which they differ.
fn meeting<P: PeriodicPoint>(points: &[P], accuracy: f64) -> Option<Located<P>> {
    let [.., a, b, c] = points else { return None };
    let seen = |point: &P| (point.asymmetry().powi(2), point.r());
    let [(x, p), (y, q), (z, r)] = [a, b, c].map(seen);
    let closes = x > y && y > z && z <= CLOSING * CLOSING && z <= STEPS * (y - z);
    let line = |(x, p): (f64, f64), (y, q): (f64, f64)| (x * q - y * p) / (x - y);
    let [far, near] = [line((x, p), (y, q)), line((y, q), (z, r))];
    let at = (x * near - z * far) / (x - z);
    (closes && at.is_finite()).then(|| {
        let error = DOUBT * (at - near).abs() + accuracy * at.abs();
        let mut met = Located::at(Kind::Flip, at, c.clone());
        (met.error, met.last) = (error, true);
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
    if still > 10.0 * accuracy || moving < UPRIGHT * still {
        return None;
    }
    let mut values: Vec<f64> = points.iter().map(P::r).collect();
    values.sort_by(f64::total_cmp);
    let last = points.last()?.clone();
    Some(Located::at(Kind::Fold, values[values.len() / 2], last))
}
