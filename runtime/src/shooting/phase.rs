//! Phase conditions: which of the points of an orbit is its start.

use crate::flow::Velocity;

/// The equation that fixes where on its orbit a start lies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Phase<const N: usize> {
    /// The state of this index has no rate: with `der(x) = v`, STRDYN's zero velocity (2.10).
    Section(usize),
    /// The start moves orthogonally to the field at a reference: Parker & Chua's (2.6).
    Orthogonal {
        /// The reference state.
        at: [f64; N],
        /// The field there.
        velocity: [f64; N],
    },
}

impl<const N: usize> Phase<N> {
    /// The condition at `state`, and its derivatives with respect to state and design variable.
    #[must_use]
    pub fn equation(&self, state: &[f64; N], velocity: &Velocity<N>) -> (f64, [f64; N], f64) {
        match self {
            Self::Section(index) => {
                let row = (*index).min(N - 1);
                (
                    velocity.f[row],
                    velocity.jacobian[row],
                    velocity.design[row],
                )
            }
            Self::Orthogonal { at, velocity } => {
                let value = (0..N).map(|j| velocity[j] * (state[j] - at[j])).sum();
                (value, *velocity, 0.0)
            }
        }
    }
}
