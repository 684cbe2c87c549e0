//! How large the states of a motion are: what errors, distances and steps are measured in.

use super::Passage;

/// An extent below this share of a state is rounding error.
const RESTS: f64 = 1e-8;
/// What is left of a state that rests at zero, as a share of what is usual for it: rounding.
pub(crate) const NOISE: f64 = 1e-15;

/// A swing below this share of a state may be the errors of what keeps still while something fast would bring it back.
pub(crate) const STILL: f64 = 1e-6;

/// Whether what a state of this size swings by may be nothing.
#[must_use]
pub(crate) fn is_still(half: f64, size: f64) -> bool {
    half > 0.0 && half < STILL * size
}

/// Half the extent of each state between `low` and `high`; `fallback`, what is usual for it, for one that rests, and so has
/// none to be measured against.
#[must_use]
pub fn half_extents(low: &[f64], high: &[f64], fallback: &[f64]) -> Vec<f64> {
    let half = |j: usize| {
        let half = 0.5 * (high[j] - low[j]);
        let rounding = (RESTS * low[j].abs().max(high[j].abs())).max(NOISE * fallback[j]);
        let moves = half > rounding && half.is_finite();
        if moves { half } else { fallback[j] }
    };
    (0..low.len()).map(half).collect()
}

/// Smallest and largest values in a passage of this time, but for how far each state has run on in it.
#[must_use]
pub(crate) fn bounds(passage: &Passage, run: &[f64], time: f64) -> (Vec<f64>, Vec<f64>) {
    let end = passage.end.state.iter().zip(run);
    let mut low: Vec<f64> = end.map(|(y, run)| y - run).collect();
    let mut high = low.clone();
    for extremum in &passage.extrema {
        let j = extremum.index;
        let value = extremum.state[j] - run[j] * (extremum.time / time);
        low[j] = low[j].min(value);
        high[j] = high[j].max(value);
    }
    (low, high)
}

/// How far two states are apart: the largest of their differences in these units.
#[must_use]
pub(crate) fn apart(a: &[f64], b: &[f64], units: &[f64]) -> f64 {
    let pairs = a.iter().zip(b).zip(units);
    pairs
        .map(|((a, b), unit)| (a - b).abs() / unit)
        .fold(0.0, f64::max)
}
