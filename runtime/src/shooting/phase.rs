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
    /// The state of this index, the phase of a drive, has this value: a stroboscopic section.
    Strobe {
        /// Which state.
        index: usize,
        /// Its value.
        at: f64,
    },
}

impl<const N: usize> Phase<N> {
    /// The condition that lets a start float: with a drive its phase stays, otherwise it moves orthogonally to the field.
    #[must_use]
    pub fn floating(drive: Option<usize>, at: [f64; N], velocity: [f64; N]) -> Self {
        match drive {
            Some(index) => Self::Strobe {
                index,
                at: at[index],
            },
            None => Self::Orthogonal { at, velocity },
        }
    }

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
            Self::Strobe { index, at } => {
                let gradient = std::array::from_fn(|j| f64::from(j == *index));
                (state[*index] - at, gradient, 0.0)
            }
        }
    }
}
