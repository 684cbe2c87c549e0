//! Crossings of a section that come back.

use crate::motion::apart;

/// So many come back on end.
const ON_END: usize = 4;
/// Most crossings between those that agree.
const LONGEST: usize = 16;
/// Returns this close, in usual sizes, are those of a motion that has settled.
pub(super) const SETTLED: f64 = 1e-7;

/// After how many crossings the last ones, the latest first, come back, each this near to one so many before; `None` if they
/// do not.
pub(super) fn returns<'a>(
    latest: impl Iterator<Item = &'a Vec<f64>>,
    usual: &[f64],
    close: f64,
) -> Option<usize> {
    let latest: Vec<&Vec<f64>> = latest.take(ON_END + LONGEST).collect();
    (1..=LONGEST).find(|&k| {
        (0..ON_END).all(|i| {
            let pair = latest.get(i).zip(latest.get(i + k));
            pair.is_some_and(|(a, b)| apart(a, b, usual) <= close)
        })
    })
}
