//! How large the states of a motion are: what errors, distances and steps are measured in.

/// An extent below this share of a state is rounding error.
const RESTS: f64 = 1e-8;

/// Half the extent of each state between `low` and `high`; `fallback` for one that rests, and so has none to be
/// measured against.
#[must_use]
pub fn half_extents(low: &[f64], high: &[f64], fallback: &[f64]) -> Vec<f64> {
    let half = |j: usize| {
        let half = 0.5 * (high[j] - low[j]);
        let moves = half > RESTS * low[j].abs().max(high[j].abs()) && half.is_finite();
        if moves { half } else { fallback[j] }
    };
    (0..low.len()).map(half).collect()
}
