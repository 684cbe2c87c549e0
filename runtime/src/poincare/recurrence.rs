//! After how many crossings a motion comes back.

use std::f64::consts::TAU;

/// Points over the longest return after which it is looked whether a motion comes nearer to it, and into how many parts they
/// are divided.
const LEAST: usize = 8;
const PARTS: usize = 4;
/// Least fall from part to part, as a logarithm, that is none of rounding.
const FALL: f64 = 1e-3;
/// What is this near to a return, as a share of the extent, may be approaching one, and by how much one fall of what it lacks
/// may exceed another.
const NEAR: f64 = 0.1;
const EVEN: f64 = 4.0;

/// The least n ≤ half the number of points such that there are only n different ones, met in turn: each
/// state to `tolerance` times its extent along the motion, from the first to the last. `None` if there
/// is none: a motion that is still settling has not come back, however slowly it drifts. The state `phase` is compared
/// on the circle.
#[must_use]
pub fn recurrence(
    points: &[Vec<f64>],
    extent: &[f64],
    phase: Option<usize>,
    tolerance: f64,
) -> Option<usize> {
    let close = |a: &[f64], b: &[f64]| shares([a, b], extent, phase).all(|gap| gap <= tolerance);
    let returns = |n: usize| (n..points.len()).all(|i| close(&points[i], &points[i % n]));
    (1..=points.len() / 2).find(|&n| returns(n))
}

/// Whether a motion comes nearer to returning earlier than after `count` points, or at all if it does not: what it lacks after
/// some number of them falls from each part of the points to the next, and evenly, as near a motion that attracts. That is a
/// sum of squares: where it turns about that motion as it falls, no state of its own falls evenly.
#[must_use]
pub fn approaches(
    points: &[Vec<f64>],
    extent: &[f64],
    phase: Option<usize>,
    count: Option<usize>,
) -> bool {
    let most = points.len() / LEAST;
    (1..count.unwrap_or(most + 1).min(most + 1)).any(|n| {
        let pairs = points.iter().zip(&points[n..]);
        let squares = |(a, b): (&Vec<f64>, &Vec<f64>)| -> f64 {
            shares([a, b], extent, phase).map(|gap| gap * gap).sum()
        };
        let gaps: Vec<f64> = pairs.map(|pair| squares(pair).sqrt()).collect();
        let largest = |part: &[f64]| part.iter().fold(0.0_f64, |most, gap| most.max(*gap));
        let parts: Vec<f64> = gaps
            .chunks(gaps.len().div_ceil(PARTS))
            .map(largest)
            .collect();
        let falls: Vec<f64> = parts.windows(2).map(|two| (two[0] / two[1]).ln()).collect();
        let least = falls.iter().copied().fold(f64::INFINITY, f64::min);
        let most = falls.iter().copied().fold(0.0, f64::max);
        falls.len() + 1 == PARTS && parts[0] <= NEAR && least > FALL && most <= EVEN * least
    })
}

/// How far two states are apart, each as a share of its extent, the phase on the circle.
fn shares<'a>(
    [a, b]: [&'a [f64]; 2],
    extent: &'a [f64],
    phase: Option<usize>,
) -> impl Iterator<Item = f64> + 'a {
    (0..extent.len()).map(move |j| {
        let gap = a[j] - b[j];
        let turns = if phase == Some(j) {
            (gap / TAU).round()
        } else {
            0.0
        };
        (gap - turns * TAU).abs() / extent[j].max(f64::MIN_POSITIVE)
    })
}
