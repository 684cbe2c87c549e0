//! Where what nearly happens begins to happen: its margin falls to zero smoothly from the one side, while what happens on the
//! other is too brief to be told from nothing.

use super::path::{Spot, Watched};
use crate::math::at_zero;

/// Distance of points from a bracket, in its widths, below which their margins tell no slope.
pub(super) const FAR: f64 = 100.0;

/// r where a margin vanishes within a bracket, and its error, by points on one side of it, each nearer to it than the one
/// before; `None` if none does.
pub(super) fn vanishes<P: Watched>(side: &[Spot<P>], bracket: [f64; 2]) -> Option<(f64, f64)> {
    let [middle, width] = [
        f64::midpoint(bracket[0], bracket[1]),
        (bracket[1] - bracket[0]).abs(),
    ];
    let far = |point: &&P| (point.r() - middle).abs() >= FAR * width;
    let mut points = side.iter().rev().map(|spot| &spot.point).filter(far);
    let [near, second, first] = [points.next()?, points.next()?, points.next()?];
    let zero = |[margin, between, far]: [f64; 3]| {
        let falls = far > between && between > margin && margin > 0.0;
        let found = at_zero([(far, first.r()), (between, second.r()), (margin, near.r())]);
        let error = (found.value - found.lines[0]).abs();
        let within = (found.value - middle).abs() <= width && error <= width;
        (falls && within).then_some((found.value, error))
    };
    let zeros = at_all([near, second, first]).filter_map(zero);
    zeros.min_by(|a, b| a.1.total_cmp(&b.1))
}

/// The values of every margin that is known at three points.
pub(super) fn at_all<P: Watched>([a, b, c]: [&P; 3]) -> impl Iterator<Item = [f64; 3]> {
    let all = a.margins(a).into_iter();
    let others = [b, c].map(|point| point.margins(a));
    all.filter_map(move |(of, margin)| {
        let beside = |i: usize| {
            let same = others[i].iter().find(|one| one.0 == of);
            same.map(|one| one.1)
        };
        Some([margin, beside(0)?, beside(1)?])
    })
}
