//! States at which it is tried what a shift changes.

use crate::math::Spread;
use crate::motion::{Flow, Velocity};

/// How many there are.
pub(super) const TRIED: usize = 12;
/// Distance in usual sizes over which slopes of gaps and relative speeds are known to nine digits.
const BESIDE: f64 = 1e-5;

/// States of these sizes, spread evenly.
pub(super) fn spread(usual: &[f64]) -> impl Iterator<Item = Vec<f64>> + '_ {
    let spread = Spread::new(usual.len());
    (0..TRIED).map(move |k| {
        let point = spread.point(k).zip(usual);
        point
            .map(|(share, size)| (2.0 * share - 1.0) * size)
            .collect()
    })
}

/// Rates at a state, and their slopes, where a motion can begin there.
pub(super) fn velocity(flow: &dyn Flow, state: &[f64]) -> Option<Velocity> {
    flow.velocity(&flow.place(state).ok()?).ok()
}

/// Slopes of the relative speed of each contact and the gap of each press, in usual sizes of the states.
pub(super) fn slopes_of_speeds(flow: &dyn Flow, state: &[f64], usual: &[f64]) -> Vec<Vec<f64>> {
    let beside = |j: usize, steps: f64| {
        let mut state = state.to_vec();
        state[j] += steps * usual[j];
        flow.speeds(&state)
    };
    let columns = (0..usual.len()).map(|j| (beside(j, BESIDE), beside(j, -BESIDE)));
    let columns: Vec<_> = columns.collect();
    let slope = |i: usize, (high, low): &(Vec<f64>, Vec<f64>)| (high[i] - low[i]) / (2.0 * BESIDE);
    let contacts = 0..flow.speeds(state).len();
    contacts
        .map(|i| columns.iter().map(|column| slope(i, column)).collect())
        .collect()
}
