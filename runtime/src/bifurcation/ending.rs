//! Why a branch goes no further.

use super::Kind;
use super::periodic::PeriodicPoint;
use crate::continuation::Located;

/// Points that are looked at.
const POINTS: usize = 8;
/// How much more the period changes than r, both relative, where a branch stands upright.
const UPRIGHT: f64 = 1e3;

/// The bifurcation that ends a branch after these points, if they point to one: a branch on which r no longer changes
/// while the orbit does is turning, however sharply.
pub fn explain<P: PeriodicPoint>(points: &[P], accuracy: f64) -> Option<Located<P>> {
    turning(&points[points.len().saturating_sub(POINTS)..], accuracy)
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
