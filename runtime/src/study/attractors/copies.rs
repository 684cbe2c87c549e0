//! Shifts of states that change nothing: an angle that has turned, a chain that has moved on.

use crate::motion::Flow;
use crate::study::work::Spread;

/// States at which a shift is tried.
const TRIED: usize = 12;
/// Rates that agree to this share of their sizes are the same.
const SAME: f64 = 1e-7;
/// A shift this small, in usual sizes, is none.
const NONE: f64 = 1e-6;

/// The state moved by whole shifts to where it is nearest to a point.
pub(super) fn unshifted(state: &[f64], point: &[f64], shift: &[f64]) -> Vec<f64> {
    let pairs = state.iter().zip(point).zip(shift);
    let along: f64 = pairs.map(|((y, p), d)| (y - p) * d).sum();
    let square: f64 = shift.iter().map(|d| d * d).sum();
    let turns = (along / square).round();
    let moved = state.iter().zip(shift).map(|(y, d)| y - turns * d);
    moved.collect()
}

/// Whether the rates are the same everywhere after this shift, as far as states of `usual` sizes tell.
pub(super) fn changes_nothing(flow: &dyn Flow, shift: &[f64], usual: &[f64]) -> bool {
    let moved = shift.iter().zip(usual);
    let mut moves = moved.clone().map(|(d, size)| d.abs() / size);
    if !moves.any(|share| share > NONE) {
        return false;
    }
    let spread = Spread::new(usual.len());
    let rates = |state: &[f64]| {
        let place = flow.place(state).ok()?;
        Some((flow.velocity(&place).ok()?.f, place.modes))
    };
    (0..TRIED).all(|k| {
        let here: Vec<f64> = spread
            .point(k)
            .zip(usual)
            .map(|(share, size)| (2.0 * share - 1.0) * size)
            .collect();
        let there: Vec<f64> = here.iter().zip(shift).map(|(y, d)| y + d).collect();
        match (rates(&here), rates(&there)) {
            (Some((f, modes)), Some((g, other))) => {
                modes == other && (f.clone() - g).amax() <= SAME * f.amax()
            }
            _ => false,
        }
    })
}
