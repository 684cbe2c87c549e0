//! Guards: functions of the state that are positive while a contact keeps its mode.

use crate::field::exact::{ExactSystem, Mode, Modes, Snapshot};
use crate::model::Model;
use crate::scalar::Scalar;

/// What ends the mode of a contact when it falls through zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Guard {
    /// Number of the contact.
    pub(super) contact: usize,
    /// The force limit that a sticking contact meets: stick − side·λ; 0 for the speed of a sliding one, and for the gap of
    /// a press, 1 for what holds that closed.
    pub(super) side: f64,
}

impl Guard {
    /// The guards of a contact in this mode.
    pub(super) fn of(contact: usize, mode: Mode) -> impl Iterator<Item = Self> {
        let sides: &[f64] = match mode {
            Mode::Stick => &[1.0, -1.0],
            Mode::SlideForward | Mode::SlideBackward | Mode::Open => &[0.0],
            Mode::Closed | Mode::Parted => &[0.0, 1.0],
            Mode::Rest => &[1.0],
            Mode::Loose | Mode::PinnedForward | Mode::PinnedBackward => &[],
        };
        sides.iter().map(move |&side| Self { contact, side })
    }

    /// Whether it is known to be affine in the state.
    pub(super) fn is_affine<M: Model<N>, const N: usize>(
        &self,
        system: &ExactSystem<M, N>,
    ) -> bool {
        self.side == 0.0 && system.is_straight(self.contact)
    }

    /// Its value over any scalar.
    pub(super) fn value<M: Model<N>, D: Scalar, const N: usize>(
        &self,
        modes: &Modes<M, N>,
        at: &Snapshot<M, D, N>,
    ) -> D {
        let i = self.contact;
        match modes.as_slice()[i] {
            mode if self.side == 0.0 => at.speed.as_ref()[i] * mode.sign(),
            Mode::Closed | Mode::Rest => at.stick.as_ref()[i],
            Mode::Parted => -at.stick.as_ref()[i],
            _ => at.stick.as_ref()[i] - at.force.as_ref()[i] * self.side,
        }
    }
}

/// Where a guard falls, or comes nearest to falling, on the dense output of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sighting {
    pub(super) guard: Guard,
    /// Where on the step, in [0, 1].
    pub(super) theta: f64,
    /// Up to where it has not risen again.
    pub(super) until: f64,
    /// How far below zero its parabola there reaches before it turns back; infinite if it does not turn.
    pub(super) depth: f64,
}

/// Which guard vanishes where a motion begins, and to which order.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Departure {
    /// Side of the guard; 0 for a speed.
    pub(super) side: f64,
    /// Number of vanishing coefficients.
    pub(super) order: usize,
}
