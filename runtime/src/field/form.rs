//! Numbers that are linear but for the phase of a drive.

use super::strip::Strip;
use crate::scalar::dot;

/// a·y + c·w with w = (1, cos φ, sin φ).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Form<const N: usize> {
    /// a.
    pub(crate) row: Strip<N>,
    /// c.
    pub(crate) wave: [f64; 3],
}

impl<const N: usize> Form<N> {
    /// From its gradient, and its values at the angles 0, π/2 and π of the phase where all else vanishes.
    pub(crate) fn new(mut gradient: [f64; N], at: [f64; 3], phase: Option<usize>) -> Self {
        if let Some(phase) = phase {
            gradient[phase] = 0.0;
        }
        Self {
            row: gradient.into(),
            wave: wave(at, phase.is_some()),
        }
    }

    /// Its value at a state with this wave.
    pub(crate) fn value(&self, state: &[f64; N], wave: &[f64; 3]) -> f64 {
        self.row.dot(state) + dot(&self.wave, wave)
    }

    /// The magnitude of its terms there.
    pub(crate) fn terms(&self, state: &[f64; N], wave: &[f64; 3]) -> f64 {
        let states = self.row.iter().map(|(j, a)| (a * state[j]).abs());
        let waves = self.wave.iter().zip(wave).map(|(c, w)| (c * w).abs());
        states.chain(waves).sum()
    }
}

/// c of what has these values at the angles 0, π/2 and π, which are one without a drive.
pub(super) fn wave(at: [f64; 3], driven: bool) -> [f64; 3] {
    if !driven {
        return [at[0], 0.0, 0.0];
    }
    let middle = 0.5 * (at[0] + at[2]);
    [middle, 0.5 * (at[0] - at[2]), at[1] - middle]
}
