//! Phase conditions: which of the points of an orbit is its start.

use nalgebra::DVector;

use crate::motion::Velocity;

/// The equation that fixes where on its orbit a start lies.
#[derive(Debug, Clone, PartialEq)]
pub enum Phase {
    /// The state of this index has no rate: with `der(x) = v`, STRDYN's zero velocity (2.10).
    Section(usize),
    /// The start moves orthogonally to the field at a reference, each state in units of its magnitude: Parker & Chua's
    /// (2.6), whatever units a model is written in.
    Orthogonal {
        /// The reference state.
        at: Vec<f64>,
        /// The field there, over the squares of the magnitudes.
        normal: DVector<f64>,
    },
    /// The state of this index, the phase of a drive, has this value: a stroboscopic section.
    Strobe {
        /// Which state.
        index: usize,
        /// Its value.
        at: f64,
    },
}

/// The gradient of the condition that a start moves orthogonally to a velocity, in units of these magnitudes.
pub(super) fn normal(velocity: &DVector<f64>, magnitude: &[f64]) -> DVector<f64> {
    DVector::from_fn(velocity.len(), |j, _| {
        velocity[j] / magnitude[j] / magnitude[j]
    })
}

impl Phase {
    /// The condition that a start moves orthogonally to the velocity at `at`, in units of these magnitudes.
    #[must_use]
    pub fn orthogonal(at: Vec<f64>, velocity: &DVector<f64>, magnitude: &[f64]) -> Self {
        let normal = normal(velocity, magnitude);
        Self::Orthogonal { at, normal }
    }

    /// The condition that lets a start float: with a drive its phase stays, otherwise it moves orthogonally to the field.
    #[must_use]
    pub fn floating(
        drive: Option<usize>,
        at: Vec<f64>,
        velocity: &DVector<f64>,
        magnitude: &[f64],
    ) -> Self {
        match drive {
            Some(index) => Self::Strobe {
                index,
                at: at[index],
            },
            None => Self::orthogonal(at, velocity, magnitude),
        }
    }

    /// The condition at `state`, and its derivatives with respect to state and design variable.
    #[must_use]
    pub fn equation(&self, state: &[f64], velocity: &Velocity) -> (f64, DVector<f64>, f64) {
        match self {
            Self::Section(index) => {
                let row = (*index).min(state.len() - 1);
                (
                    velocity.f[row],
                    velocity.jacobian.row(row).transpose(),
                    velocity.design[row],
                )
            }
            Self::Orthogonal { at, normal } => {
                let value = (0..state.len())
                    .map(|j| normal[j] * (state[j] - at[j]))
                    .sum();
                (value, normal.clone(), 0.0)
            }
            Self::Strobe { index, at } => {
                let gradient = DVector::from_fn(state.len(), |j, _| f64::from(j == *index));
                (state[*index] - at, gradient, 0.0)
            }
        }
    }
}
