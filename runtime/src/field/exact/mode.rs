//! How a contact moves: sliding one way or the other, or sticking.

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

    /// Sign of w: 1, −1, or 0 while sticking.
    #[must_use]
    pub fn sign(self) -> f64 {
        match self {
            Self::SlideForward => 1.0,
            Self::SlideBackward => -1.0,
            Self::Stick => 0.0,
        }
    }
}

impl fmt::Display for Mode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::SlideForward => "slip+",
            Self::SlideBackward => "slip-",
            Self::Stick => "stick",
        })
    }
}

/// The mode of every contact of a model.
pub struct Modes<M: Model<N>, const N: usize>(M::PerContact<Mode>);

impl<M: Model<N>, const N: usize> Modes<M, N> {
    /// The mode of each contact as a function of its number.
    #[must_use]
    pub fn from_fn(mode: impl FnMut(usize) -> Mode) -> Self {
        Self(Inline::from_fn(mode))
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
