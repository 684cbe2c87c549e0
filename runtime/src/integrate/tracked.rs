//! What a motion is followed with between events: its state alone, or the state with its derivatives.

use super::{Carried, Motion, Propagator};

/// A state on its way, or one with the derivatives of the motion that led to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Tracked<const N: usize> {
    /// The state alone.
    State([f64; N]),
    /// With its derivatives.
    Motion(Motion<N>),
}

impl<const N: usize> Tracked<N> {
    /// A motion that begins here.
    pub(crate) fn begin(state: [f64; N], derivatives: bool) -> Self {
        match derivatives {
            true => Self::Motion(Motion::from(state)),
            false => Self::State(state),
        }
    }

    /// The state.
    pub(crate) fn state(&self) -> &[f64; N] {
        match self {
            Self::State(state) | Self::Motion(Motion { state, .. }) => state,
        }
    }

    /// The state, to be corrected or to jump.
    pub(crate) fn state_mut(&mut self) -> &mut [f64; N] {
        match self {
            Self::State(state) | Self::Motion(Motion { state, .. }) => state,
        }
    }

    /// The state with its derivatives, if they are carried.
    pub(crate) fn motion(&mut self) -> Option<&mut Motion<N>> {
        match self {
            Self::State(_) => None,
            Self::Motion(motion) => Some(motion),
        }
    }

    /// This, led to `end` by a step whose derivatives are asked for only where they are carried.
    pub(crate) fn led_to(&self, end: [f64; N], step: impl FnOnce() -> Propagator<N>) -> Self {
        match self {
            Self::State(_) => Self::State(end),
            Self::Motion(motion) => Self::Motion(Motion {
                state: end,
                ..motion.through(&step())
            }),
        }
    }

    /// Whether every number is finite.
    pub(crate) fn is_finite(&self) -> bool {
        match self {
            Self::State(state) => state.is_finite(),
            Self::Motion(motion) => motion.is_finite(),
        }
    }
}
