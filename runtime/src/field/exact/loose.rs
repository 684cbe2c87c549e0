//! What presses decide for the contacts that they press, and what is known of the presses themselves.

use super::mode::{Mode, Modes};
use super::pressed::hold_terms;
use super::rest::loose;
use super::system::ExactSystem;
use super::tied::factor;
use crate::model::Model;

impl<M: Model<N>, const N: usize> ExactSystem<M, N> {
    /// The modes with those contacts loose, and those pinned, that presses make so.
    pub(crate) fn pressed(&self, modes: Modes<M, N>, state: &[f64; N]) -> Modes<M, N> {
        if const { Modes::<M, N>::PRESSED } {
            let loosened = self.loosened(modes, self.speeds(state).as_ref());
            self.pinned(loosened, state)
        } else {
            modes
        }
    }

    /// The magnitude of the terms of what holds a press closed.
    pub(crate) fn terms_of_hold(&self, state: &[f64; N], press: usize) -> f64 {
        hold_terms::<M, N>(&self.plain, state, press)
    }

    /// The modes with those contacts loose, and only those, whose presses are open and which hold with no force then;
    /// what is loose no longer slides the way it moves.
    pub(crate) fn loosened(&self, mut modes: Modes<M, N>, speeds: &[f64]) -> Modes<M, N> {
        let reads = |i: usize| !M::INFO.contacts[i].presses.is_empty();
        if !(0..M::INFO.contacts.len()).any(reads) {
            return modes;
        }
        let before = modes;
        let open = |i: usize| !before.as_slice()[i].acts();
        let loose = loose::<M, N>(&self.turned, open);
        for i in (0..M::INFO.contacts.len()).filter(|&i| reads(i)) {
            let is_loose = before.as_slice()[i] == Mode::Loose;
            let unloaded =
                loose.as_ref()[i] && M::INFO.contacts[i].presses.iter().any(|&i| open(i));
            match (unloaded, is_loose) {
                (true, false) => modes.set(i, Mode::Loose),
                (false, true) => modes.set(i, Mode::sliding(speeds[i])),
                _ => {}
            }
        }
        modes
    }

    /// Whether the force of a press is no power series in the depth, as that of Hertz is not.
    pub(crate) fn is_rough(&self, press: usize) -> bool {
        self.rough.as_ref()[press]
    }
}

impl<M: Model<N>, const N: usize> ExactSystem<M, N> {
    /// Whether a contact has no relative speed wherever the gap of a press stays as it is.
    pub(crate) fn is_tied(&self, contact: usize, press: usize) -> bool {
        self.ties.as_ref()[contact].as_ref()[press] && !self.is_idle(contact)
    }

    /// How much the relative speed of a tied contact is for each unit of the rate of the gap.
    pub(crate) fn factor(&self, state: &[f64; N], contact: usize, press: usize) -> f64 {
        factor::<M, N>(&self.plain, state, contact, press)
    }

    /// The modes with those contacts pinned, and only those, that move with presses at rest.
    pub(crate) fn pinned(&self, mut modes: Modes<M, N>, state: &[f64; N]) -> Modes<M, N> {
        let before = modes;
        for (i, mode) in before.as_slice().iter().enumerate() {
            let holder = before.resting().find(|&press| self.is_tied(i, press));
            match (holder, mode.unpinned()) {
                (Some(press), None) if mode.rubs() => {
                    modes.set(i, Mode::pinned(self.factor(state, i, press)));
                }
                (None, Some(slides)) => modes.set(i, slides),
                _ => {}
            }
        }
        modes
    }
}
