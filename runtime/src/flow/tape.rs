//! Passages that are kept, so that a computation which was ended can be gone through again in no time.
//!
//! A branch is more than its points: steps that were too long and orbits between two others decide how it goes on. But
//! all of that follows from where its passages end. A computation that is done again, with those passages read instead of
//! integrated, comes in the same way to where it was ended, and goes on from there to the same bits.

use std::cell::{Cell, RefCell};
use std::collections::VecDeque;

use borsh::{BorshDeserialize, BorshSerialize};

use super::exact::Glide;
use super::{Derivatives, Family, Flow, FlowError, Passage, Place, Steered, Velocity, Want};
use crate::field::Design;
use crate::integrate::Tolerance;

/// Told of a record.
type Note<'a> = &'a dyn Fn(&[u8]);

/// The passages of one computation in their order.
///
/// The order counts: only one thread can use it.
pub struct Tape<'a> {
    /// Records of an earlier run that have not been met yet.
    known: RefCell<VecDeque<Vec<u8>>>,
    /// Told of each passage that was computed.
    note: Option<Note<'a>>,
    /// Whether this run has gone another way than the earlier one.
    strayed: Cell<bool>,
}

impl<'a> Tape<'a> {
    /// Nothing is known and nothing kept.
    #[must_use]
    pub fn blank() -> Self {
        Self {
            known: RefCell::default(),
            note: None,
            strayed: Cell::new(false),
        }
    }

    /// A tape with the records of an earlier run of the same computation; `note` keeps those that follow.
    #[must_use]
    pub fn new(known: impl IntoIterator<Item = Vec<u8>>, note: Note<'a>) -> Self {
        Self {
            known: RefCell::new(known.into_iter().collect()),
            note: Some(note),
            ..Self::blank()
        }
    }

    /// A family whose passages are kept here.
    pub fn record<F>(&'a self, family: F) -> Taped<'a, F> {
        Taped { family, tape: self }
    }

    /// What is asked by `key`: as it is known, or computed and noted.
    ///
    /// A failure is noted without its reason: it is found again where the computation is gone through again.
    fn recall<T: BorshSerialize + BorshDeserialize, E>(
        &self,
        key: &impl BorshSerialize,
        compute: impl FnOnce() -> Result<T, E>,
    ) -> Result<T, E> {
        let Some(note) = self.note else {
            return compute();
        };
        let mut record = borsh::to_vec(key).unwrap_or_default();
        let known = self.known.borrow_mut().pop_front();
        if let Some(known) = known {
            let found = known.strip_prefix(record.as_slice());
            match found.map(|found| (found, T::try_from_slice(found))) {
                Some(([], _)) => return compute(),
                Some((_, Ok(found))) => return Ok(found),
                _ => self.stray(),
            }
        }
        let found = compute();
        if let Ok(found) = &found {
            // What cannot be written is computed again.
            record.extend(borsh::to_vec(found).unwrap_or_default());
        }
        if !self.strayed.get() {
            note(&record);
        }
        found
    }

    /// The rest of the records is worth nothing.
    fn stray(&self) {
        self.known.borrow_mut().clear();
        self.strayed.set(true);
    }
}

/// A family whose passages are kept on a [`Tape`].
#[derive(Clone, Copy)]
pub struct Taped<'a, F> {
    family: F,
    tape: &'a Tape<'a>,
}

/// A flow whose passages are kept on a [`Tape`].
pub struct TapedFlow<'a, F> {
    flow: F,
    r: f64,
    tape: &'a Tape<'a>,
}

impl<'a, F> Taped<'a, F> {
    /// Where its passages are kept.
    pub fn tape(&self) -> &'a Tape<'a> {
        self.tape
    }
}

impl<'a, F: Family<N>, const N: usize> Family<N> for Taped<'a, F>
where
    <F::Flow as Flow<N>>::Mode: BorshSerialize + BorshDeserialize,
{
    type Flow = TapedFlow<'a, F::Flow>;

    fn at(&self, r: f64) -> Result<Self::Flow, FlowError> {
        Ok(TapedFlow {
            flow: self.family.at(r)?,
            r,
            tape: self.tape,
        })
    }

    fn with_magnitude(&self, magnitude: [f64; N]) -> Self {
        self.tape.record(self.family.with_magnitude(magnitude))
    }

    fn with_tolerance(&self, tolerance: Tolerance) -> Self {
        self.tape.record(self.family.with_tolerance(tolerance))
    }
}

impl<F: Steered<N>, const N: usize> Steered<N> for Taped<'_, F>
where
    <F::Flow as Flow<N>>::Mode: BorshSerialize + BorshDeserialize,
{
    fn steered(&self, design: Design, fixed: Design, value: f64) -> Self {
        self.tape.record(self.family.steered(design, fixed, value))
    }
}

impl<F: Flow<N>, const N: usize> Flow<N> for TapedFlow<'_, F>
where
    F::Mode: BorshSerialize + BorshDeserialize,
{
    type Mode = F::Mode;
    const PHASE: Option<usize> = F::PHASE;

    fn place(&self, state: [f64; N]) -> Result<Place<N, F::Mode>, FlowError> {
        self.flow.place(state)
    }

    fn sticking(mode: &F::Mode) -> usize {
        F::sticking(mode)
    }

    fn advance(
        &self,
        from: &Place<N, F::Mode>,
        time: f64,
        want: Want,
    ) -> Result<Passage<N, F::Mode>, FlowError> {
        let advance = || self.flow.advance(from, time, want);
        self.tape.recall(&(self.r, from, time, want), advance)
    }

    fn velocity(&self, at: &Place<N, F::Mode>) -> Result<Velocity<N>, FlowError> {
        self.flow.velocity(at)
    }
}

impl<F: Glide<N>, const N: usize> Glide<N> for TapedFlow<'_, F>
where
    F::Mode: BorshSerialize + BorshDeserialize,
{
    fn glide(
        &self,
        from: &Place<N, F::Mode>,
        time: f64,
    ) -> Result<(Place<N, F::Mode>, Derivatives<N>), FlowError> {
        let glide = || self.flow.glide(from, time);
        self.tape.recall(&(self.r, from, time), glide)
    }

    fn touch(&self, at: &Place<N, F::Mode>, contact: usize) -> Result<Option<[f64; 2]>, FlowError> {
        self.flow.touch(at, contact)
    }
}

#[cfg(test)]
mod tests;
