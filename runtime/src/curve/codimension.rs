//! What is looked for on a curve: points where a second condition is met, of codimension two, and the ends of its range.

use nalgebra::Complex;

use super::condition::pairs;
use super::isola::Unfolding;
use super::point::{CurvePoint, Unfolds};
use crate::bifurcation::test_function::{flip, fold};
use crate::continuation::{Kind, Monitor, Verdict};
use crate::shooting::Orbit;

type Point = CurvePoint<Orbit>;

/// The part along the other variable that is left of a tangent at a cusp, relative to its neighbours.
const CUSP: f64 = 0.1;

/// The part of a tangent along a variable that is constant.
const CONSTANT: f64 = 1e-6;

/// What is looked for on a curve of this kind.
pub(super) fn monitors<'a>(of: Kind, unfolding: &'a Unfolding) -> Vec<Monitor<'a, Point>> {
    let last = |kind| move |_: [&Point; 2], _: &Point| Some(Verdict::Last(kind));
    let multipliers = |point: &Point| point.floquet().multipliers.clone();
    let cosine = move |point: &Point| cosine(&multipliers(point)).unwrap_or(f64::NAN);
    match of {
        Kind::Fold => vec![
            still(unfolding, 1),
            still(unfolding, 0),
            Monitor::new(Kind::FoldFlip, move |point| flip(&multipliers(point))),
            Monitor::new(Kind::Resonance1, move |point| {
                fold(&without(&multipliers(point), 1.0))
            }),
        ],
        Kind::Flip => vec![
            Monitor::new(Kind::FoldFlip, move |point| fold(&multipliers(point))),
            Monitor::new(Kind::Resonance2, move |point| {
                flip(&without(&multipliers(point), -1.0))
            }),
        ],
        // Beyond a double multiplier ±1 a torus curve has a neutral saddle.
        Kind::Torus => vec![
            Monitor::new(Kind::Resonance1, move |point| 1.0 - cosine(point))
                .judged(last(Kind::Resonance1)),
            Monitor::new(Kind::Resonance2, move |point| 1.0 + cosine(point))
                .judged(last(Kind::Resonance2)),
            Monitor::new(Kind::Resonance3, move |point| 0.5 + cosine(point)),
            Monitor::new(Kind::Resonance4, cosine),
        ],
        _ => Vec::new(),
    }
}

/// Where the curve of folds stands still in one variable: in the other one, too, at a cusp, which is told of once; else
/// branches along that other one appear there, vanish, or exchange their parts.
pub(super) fn still<T: Unfolds + 'static>(
    unfolding: &Unfolding,
    still: usize,
) -> Monitor<'_, CurvePoint<T>> {
    let monitor = Monitor::new(Kind::Cusp, move |point: &CurvePoint<T>| {
        point.tangent[still]
    });
    // A curve along which one variable is constant all the way stands still nowhere.
    let moves =
        move |ends: [&CurvePoint<T>; 2]| ends.iter().any(|end| end.tangent[still].abs() > CONSTANT);
    let marked = monitor
        .only_if(moves)
        .marked(move |point| point.still = Some(still));
    marked.judged(move |[before, after], at| {
        let other = |point: &CurvePoint<T>| point.tangent[1 - still].abs();
        let kind = if other(at) <= CUSP * other(before).max(other(after)) {
            (still == 1).then_some(Kind::Cusp)
        } else {
            at.of.unfolded([at.p, at.q], unfolding, still)
        };
        kind.map(Verdict::Special)
    })
}

/// Where p leaves its range.
pub(super) fn window<'a, P>(
    range: [f64; 2],
    p: impl Fn(&P) -> f64 + Copy + 'a,
) -> impl Iterator<Item = Monitor<'a, P>> {
    let bound = move |bound: f64| Monitor::new(Kind::Window, move |point: &P| p(point) - bound);
    range
        .into_iter()
        .map(move |end| bound(end).judged(|_, _| Some(Verdict::Bound)))
}

/// All multipliers but the one nearest to `critical`.
fn without(multipliers: &[Complex<f64>], critical: f64) -> Vec<Complex<f64>> {
    let distance = |i: &usize| (multipliers[*i] - critical).norm();
    let nearest = (0..multipliers.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
    let others = (0..multipliers.len()).filter(|i| Some(*i) != nearest);
    others.map(|i| multipliers[i]).collect()
}

/// cos θ of the pair e^{±iθ}; beyond ±1 where that pair is real.
fn cosine(multipliers: &[Complex<f64>]) -> Option<f64> {
    let off = |(a, b): &(Complex<f64>, Complex<f64>)| (a * b - 1.0).norm();
    let pair = pairs(multipliers).min_by(|x, y| off(x).total_cmp(&off(y)));
    pair.map(|(a, b)| 0.5 * (a + b).re)
}
