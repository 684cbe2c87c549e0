//! How a contact moves: sliding one way or the other, or sticking; pressing, or open.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::model::Model;
use crate::scalar::Inline;

/// The mode of one contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Mode {
    /// w > 0.
    SlideForward,
    /// w < 0.
    SlideBackward,
    /// w = 0, held by a force within the limit at rest.
    Stick,
    /// No force, whatever w is: what presses it is open.
    Loose,
    /// w = 0 because a press rests that moves with it: which of them holds how much is not told, so that its force is the
    /// limit at rest, against the press opening, and the reaction what is left to hold; it goes on with w > 0.
    PinnedForward,
    /// The same, going on with w < 0.
    PinnedBackward,
    /// A press whose gap is open.
    Open,
    /// A press whose gap is closed, and whose force pushes.
    Closed,
    /// A press whose force has fallen to zero before its gap opened: its law would pull.
    Parted,
    /// A press that does not give way, its gap kept closed by its reaction.
    Rest,
}

impl Mode {
    /// The sliding mode with w of this sign.
    #[must_use]
    pub fn sliding(sign: f64) -> Self {
        if sign > 0.0 {
            Self::SlideForward
        } else {
            Self::SlideBackward
        }
    }

    /// The mode of a contact beside a press at rest that opens with w of this sign.
    #[must_use]
    pub fn pinned(sign: f64) -> Self {
        if sign > 0.0 {
            Self::PinnedForward
        } else {
            Self::PinnedBackward
        }
    }

    /// The mode in which a contact goes on that no press pins any more; `None` of any other.
    #[must_use]
    pub fn unpinned(self) -> Option<Self> {
        match self {
            Self::PinnedForward => Some(Self::SlideForward),
            Self::PinnedBackward => Some(Self::SlideBackward),
            _ => None,
        }
    }

    /// Sign of w, or of the gap of a press: 1, −1, or 0 where the mode says nothing of it.
    #[must_use]
    pub fn sign(self) -> f64 {
        match self {
            Self::SlideForward | Self::Open => 1.0,
            Self::SlideBackward | Self::Closed | Self::Parted => -1.0,
            Self::Stick | Self::Loose | Self::PinnedForward | Self::PinnedBackward | Self::Rest => {
                0.0
            }
        }
    }

    /// Whether there is a force: that of a press that is closed, or of a contact that is not loose.
    #[must_use]
    pub fn acts(self) -> bool {
        !matches!(self, Self::Loose | Self::Open | Self::Parted)
    }

    /// Whether it is the mode of a press.
    #[must_use]
    pub fn is_of_press(self) -> bool {
        matches!(self, Self::Open | Self::Closed | Self::Parted | Self::Rest)
    }

    /// Whether its force is what keeps a speed, or the rate of a gap, at zero.
    #[must_use]
    pub fn binds(self) -> bool {
        matches!(self, Self::Stick | Self::Rest)
    }

    /// How many directions of motion it takes away: a gap that stays closed has neither depth nor rate.
    #[must_use]
    pub fn lost(self) -> usize {
        match self {
            Self::Stick => 1,
            Self::Rest => 2,
            _ => 0,
        }
    }

    /// The mode of this name; `None` also where it says not which way.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        const NAMED: [Mode; 8] = [
            Mode::SlideForward,
            Mode::SlideBackward,
            Mode::Stick,
            Mode::Loose,
            Mode::Open,
            Mode::Closed,
            Mode::Parted,
            Mode::Rest,
        ];
        NAMED.into_iter().find(|mode| mode.to_string() == name)
    }

    /// Whether it is that of a contact that sticks or slides.
    #[must_use]
    pub fn rubs(self) -> bool {
        matches!(self, Self::SlideForward | Self::SlideBackward | Self::Stick)
    }
}

impl fmt::Display for Mode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::SlideForward => "slip+",
            Self::SlideBackward => "slip-",
            Self::Stick => "stick",
            Self::Loose => "loose",
            Self::PinnedForward | Self::PinnedBackward => "pinned",
            Self::Open => "open",
            Self::Closed => "closed",
            Self::Parted => "parted",
            Self::Rest => "rest",
        })
    }
}

/// The mode of every contact of a model.
pub struct Modes<M: Model<N>, const N: usize>(M::PerContact<Mode>);

impl<M: Model<N>, const N: usize> Modes<M, N> {
    /// Whether there are presses. What only these need is not compiled for other models, where a condition by itself asks.
    pub(crate) const PRESSED: bool = !M::INFO.presses.is_empty();

    /// The mode of each contact as a function of its number.
    #[must_use]
    pub fn from_fn(mode: impl FnMut(usize) -> Mode) -> Self {
        Self(Inline::from_fn(mode))
    }

    /// Every contact that rubs sticks, and every press is open.
    #[must_use]
    pub fn held() -> Self {
        Self::from_fn(|i| match M::INFO.contacts.get(i) {
            Some(_) => Mode::Stick,
            None => Mode::Open,
        })
    }

    /// One press at rest, and nothing else.
    #[must_use]
    pub(crate) fn resting_alone(press: usize) -> Self {
        Self::from_fn(|i| match i {
            i if i == press => Mode::Rest,
            i if i < M::INFO.contacts.len() => Mode::Loose,
            _ => Mode::Open,
        })
    }

    /// In the order of declaration of the contacts.
    #[must_use]
    pub fn as_slice(&self) -> &[Mode] {
        self.0.as_ref()
    }

    /// Sets the mode of one contact; without effect if there is no such contact.
    pub fn set(&mut self, contact: usize, mode: Mode) {
        if let Some(place) = self.0.as_mut().get_mut(contact) {
            *place = mode;
        }
    }

    /// The numbers of the contacts that stick.
    pub fn sticking(&self) -> impl Iterator<Item = usize> {
        let stick = |(i, mode): (usize, &Mode)| (*mode == Mode::Stick).then_some(i);
        self.as_slice().iter().enumerate().filter_map(stick)
    }

    /// The numbers of the contacts whose forces are solved for: of those that stick, and of presses at rest.
    pub fn bound(&self) -> impl Iterator<Item = usize> {
        let binds = |(i, mode): (usize, &Mode)| mode.binds().then_some(i);
        self.as_slice().iter().enumerate().filter_map(binds)
    }

    /// The numbers of the presses at rest.
    pub fn resting(&self) -> impl Iterator<Item = usize> {
        let first = M::INFO.contacts.len();
        let presses = self.as_slice().iter().enumerate().skip(first);
        presses.filter_map(|(i, mode)| (*mode == Mode::Rest).then_some(i))
    }

    /// Of which contacts something is true in their modes.
    pub(crate) fn which(&self, is: fn(Mode) -> bool) -> M::PerContact<bool> {
        Inline::from_fn(|i| is(self.as_slice()[i]))
    }

    /// Whether any press is at rest.
    #[must_use]
    pub fn rests(&self) -> bool {
        self.resting().next().is_some()
    }
}

impl<M: Model<N>, const N: usize> Clone for Modes<M, N> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: Model<N>, const N: usize> Copy for Modes<M, N> {}

impl<M: Model<N>, const N: usize> PartialEq for Modes<M, N> {
    fn eq(&self, other: &Self) -> bool {
        self.as_slice() == other.as_slice()
    }
}

impl<M: Model<N>, const N: usize> Eq for Modes<M, N> {}

impl<M: Model<N>, const N: usize> fmt::Debug for Modes<M, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.as_slice()).finish()
    }
}
