//! After how many crossings a motion comes back.

use std::f64::consts::TAU;

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
    let near = |j: usize, gap: f64| {
        let turns = if phase == Some(j) {
            (gap / TAU).round()
        } else {
            0.0
        };
        (gap - turns * TAU).abs() <= tolerance * extent[j].max(f64::MIN_POSITIVE)
    };
    let close = |a: &[f64], b: &[f64]| (0..extent.len()).all(|j| near(j, a[j] - b[j]));
    let returns = |n: usize| (n..points.len()).all(|i| close(&points[i], &points[i % n]));
    (1..=points.len() / 2).find(|&n| returns(n))
}
