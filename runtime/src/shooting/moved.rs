//! States moved by one shift to where they are nearest to a point.

/// The state moved by any share of a shift to where it is nearest to a point.
pub(crate) fn slid(state: &[f64], point: &[f64], shift: &[f64]) -> Vec<f64> {
    let turns = shifts_apart(state, point, shift);
    moved(state, shift, turns)
}

/// The state moved by whole shifts to where it is nearest to a point.
pub(crate) fn unshifted(state: &[f64], point: &[f64], shift: &[f64]) -> Vec<f64> {
    let turns = shifts_apart(state, point, shift).round();
    moved(state, shift, turns)
}

/// How many shifts a state is away from a point.
fn shifts_apart(state: &[f64], point: &[f64], shift: &[f64]) -> f64 {
    let pairs = state.iter().zip(point).zip(shift);
    let along: f64 = pairs.map(|((y, p), d)| (y - p) * d).sum();
    let square: f64 = shift.iter().map(|d| d * d).sum();
    along / square
}

/// The state moved back by so many shifts.
pub(super) fn moved(state: &[f64], shift: &[f64], turns: f64) -> Vec<f64> {
    let back = state.iter().zip(shift).map(|(y, d)| y - turns * d);
    back.collect()
}
