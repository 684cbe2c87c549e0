//! Why a branch goes no further.

use super::Kind;
use super::periodic::{Margin, PeriodicPoint};
use crate::continuation::Located;

/// Points at the very end that may be too uncertain to show what they lead to.
const LATE: usize = 2;
/// Points that are looked at.
const POINTS: usize = 8;
/// A rate that has fallen to this share of its value some points before is about to vanish.
const SHRUNK: f64 = 0.1;
/// Points through which r is extrapolated as a function of a rate.
const DEGREE: usize = 4;
/// Distance to where it vanishes, in steps of r, up to which that may be extrapolated.
const STEPS: f64 = 30.0;
/// How much more the period changes than r, both relative, where a branch stands upright.
const UPRIGHT: f64 = 1e3;

/// The bifurcation that ends a branch after these points, if they point to one.
///
/// An event that is about to be missed is a graze: nothing continues the orbit beyond it. A branch on
/// which r no longer changes while the orbit does is turning, however sharply.
pub fn explain<P: PeriodicPoint>(points: &[P], accuracy: f64) -> Option<Located<P>> {
    let last = &points[points.len().saturating_sub(POINTS)..];
    let earlier = (0..=LATE).filter_map(|late| last.get(..last.len().checked_sub(late)?));
    earlier
        .filter_map(missed)
        .next()
        .or_else(|| turning(last, accuracy))
}

/// The event whose guard falls ever more slowly, where it would no longer fall.
fn missed<P: PeriodicPoint>(points: &[P]) -> Option<Located<P>> {
    let last = points.last()?;
    let same = points.iter().filter(|point| point.same_regime(last));
    let history: Vec<(f64, Vec<Margin>)> =
        same.map(|point| (point.r(), point.close_calls())).collect();
    let graze = |margin: &&Margin| margin.kind != Kind::VanishingSegment;
    let (_, nearest) = history.last()?;
    let vanishing = nearest.iter().filter(graze).filter_map(|margin| {
        let series: Vec<(f64, f64)> = history
            .iter()
            .filter_map(|(r, margins)| Some((*r, margin.smallest(margins)?)))
            .collect();
        extrapolate(&series).map(|r| (margin.kind, r))
    });
    let steps = |r: f64| (r - last.r()).abs();
    let (kind, r) = vanishing.min_by(|a, b| steps(a.1).total_cmp(&steps(b.1)))?;
    Some(Located::at(kind, r, last.clone()))
}

/// r where a series of (r, rate) vanishes, if it falls towards zero.
///
/// r is a smooth function of the rate: quadratic where the orbit does not feel the change of its last
/// event, with a linear part where it does.
fn extrapolate(series: &[(f64, f64)]) -> Option<f64> {
    let [.., a, b, c] = series else {
        return None;
    };
    let largest = series.iter().map(|(_, rate)| *rate).fold(0.0, f64::max);
    let falls = c.1 < b.1 && b.1 < a.1 && c.1 <= SHRUNK * largest;
    let r = neville(&series[series.len().saturating_sub(DEGREE)..]);
    let near = (r - c.0).abs() <= STEPS * (c.0 - b.0).abs();
    (falls && near && r.is_finite()).then_some(r)
}

/// The polynomial r(rate) through these (r, rate), at rate 0.
fn neville(points: &[(f64, f64)]) -> f64 {
    let mut r: Vec<f64> = points.iter().map(|point| point.0).collect();
    let rate = |i: usize| points[i].1;
    for order in 1..points.len() {
        for i in 0..points.len() - order {
            let (from, to) = (rate(i), rate(i + order));
            r[i] = (to * r[i] - from * r[i + 1]) / (to - from);
        }
    }
    r[0]
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rate_that_falls_like_a_root_or_a_line_is_extrapolated() {
        let distances = [0.1, 1e-2, 1e-3, 1e-4, 1e-5];
        let root = distances.map(|d: f64| (2.0 - d - 0.3 * d * d, (d * (1.0 + 0.5 * d)).sqrt()));
        let line = distances.map(|d: f64| (2.0 - d - 0.3 * d * d, d * (1.0 + 0.5 * d)));
        for series in [root, line] {
            let r = extrapolate(&series).unwrap();
            assert!((r - 2.0).abs() < 1e-7, "{r}");
        }
    }

    #[test]
    fn what_does_not_vanish_is_not_extrapolated() {
        assert_eq!(extrapolate(&[(1.0, 1.0), (1.1, 0.9), (1.2, 0.8)]), None);
    }
}
