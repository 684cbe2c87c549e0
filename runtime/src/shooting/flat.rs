//! Motions that are no oscillation: at rest, or running on evenly.

use super::guess::Guess;
use super::shot::Shot;
use crate::flow::FlowError;
use crate::motion::Flow;

/// An orbit whose extent is below this share of its states is an equilibrium.
pub(super) const EXTENT: f64 = 1e-6;

/// Whether nothing changes once around but what runs on, and that as evenly as it begins.
pub(super) fn is_flat(shot: &Shot, magnitude: &[f64]) -> bool {
    let run = |j: usize| shot.shift.as_ref().map_or(0.0, |run| run[j]);
    let (low, high) = shot.extent();
    (0..low.len()).all(|j| {
        let size = low[j].abs().max(high[j].abs()).max(magnitude[j]);
        let evenly = shot.velocity.f[j] * shot.period - run(j);
        high[j] - low[j] - run(j).abs() <= EXTENT * size
            && (run(j) == 0.0 || evenly.abs() <= EXTENT * run(j).abs())
    })
}

/// Whether a guess hardly moves in its period: there Newton's matrix is singular for any period.
pub(super) fn at_rest(flow: &dyn Flow, guess: &Guess) -> Result<bool, FlowError> {
    let velocity = flow.velocity(&guess.place)?.f;
    Ok(
        (0..velocity.len())
            .all(|j| velocity[j].abs() * guess.period <= EXTENT * guess.magnitude[j]),
    )
}
