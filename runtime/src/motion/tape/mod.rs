//! Passages that are kept, so that a computation which was ended can be gone through again in no time.
//!
//! A branch is more than its points: steps that were too long and orbits between two others decide how it goes on. But
//! all of that follows from where its passages end. A computation that is done again, with those passages read instead of
//! integrated, comes in the same way to where it was ended, and goes on from there to the same bits.

use std::collections::VecDeque;
use std::fmt;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use borsh::{BorshDeserialize, BorshSerialize};

use super::{Contacts, Derivatives, Family, Flow, Flows, Passage, Place, Reading, Velocity};
use crate::field::Design;
use crate::flow::{FlowError, Want};
use crate::integrate::Tolerance;
use crate::model::Values;

/// Told of a record.
pub type Note = Box<dyn Fn(&[u8]) + Send + Sync>;

/// The passages of one computation in their order.
///
/// The order counts: only one thread can use it.
pub struct Tape {
    known: Mutex<Known>,
    /// Told of each passage that was computed.
    note: Note,
}

/// Records of an earlier run.
struct Known {
    /// Those that have not been met yet.
    records: VecDeque<Vec<u8>>,
    /// Whether this run has gone another way than the earlier one.
    strayed: bool,
}

impl fmt::Debug for Tape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a tape with {} records", self.known().records.len())
    }
}

impl Tape {
    /// A tape with the records of an earlier run of the same computation; `note` keeps those that follow.
    #[must_use]
    pub fn new(known: impl IntoIterator<Item = Vec<u8>>, note: Note) -> Arc<Self> {
        let known = Known {
            records: known.into_iter().collect(),
            strayed: false,
        };
        Arc::new(Self {
            known: Mutex::new(known),
            note,
        })
    }

    fn known(&self) -> MutexGuard<'_, Known> {
        self.known.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What is asked by `key`: as it is known, or computed and noted.
    ///
    /// A failure is noted without its reason: it is found again where the computation is gone through again.
    fn recall<T: BorshSerialize + BorshDeserialize, E>(
        &self,
        key: &impl BorshSerialize,
        compute: impl FnOnce() -> Result<T, E>,
    ) -> Result<T, E> {
        let mut record = borsh::to_vec(key).unwrap_or_default();
        let known = self.known().records.pop_front();
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
        if !self.known().strayed {
            (self.note)(&record);
        }
        found
    }

    /// The rest of the records is worth nothing.
    fn stray(&self) {
        let mut known = self.known();
        known.records.clear();
        known.strayed = true;
    }
}

/// A family whose passages are kept on a [`Tape`].
pub(super) struct Taped {
    family: Family,
    tape: Arc<Tape>,
}

impl Taped {
    pub(super) fn new(family: Family, tape: Arc<Tape>) -> Self {
        Self { family, tape }
    }
}

/// A flow whose passages are kept on a [`Tape`].
struct TapedFlow {
    flow: Box<dyn Flow>,
    r: f64,
    tape: Arc<Tape>,
}

impl Flows for Taped {
    fn order(&self) -> usize {
        self.family.order()
    }

    fn phase(&self) -> Option<usize> {
        self.family.phase()
    }

    fn at(&self, r: f64) -> Result<Box<dyn Flow>, FlowError> {
        Ok(Box::new(TapedFlow {
            flow: self.family.at(r)?,
            r,
            tape: self.tape.clone(),
        }))
    }

    fn with_tolerance(&self, tolerance: Tolerance) -> Family {
        self.family.with_tolerance(tolerance).recorded(&self.tape)
    }

    fn with_magnitude(&self, magnitude: &[f64]) -> Family {
        self.family.with_magnitude(magnitude).recorded(&self.tape)
    }

    fn steered(&self, design: Design, fixed: Design, value: f64) -> Family {
        self.family
            .steered(design, fixed, value)
            .recorded(&self.tape)
    }
}

impl Flow for TapedFlow {
    fn order(&self) -> usize {
        self.flow.order()
    }

    fn phase(&self) -> Option<usize> {
        self.flow.phase()
    }

    fn values(&self, state: &[f64]) -> Values {
        self.flow.values(state)
    }

    fn place(&self, state: &[f64]) -> Result<Place, FlowError> {
        self.flow.place(state)
    }

    fn advance(&self, from: &Place, time: f64, want: Want) -> Result<Passage, FlowError> {
        let advance = || self.flow.advance(from, time, want);
        self.tape.recall(&(self.r, from, time, want), advance)
    }

    fn velocity(&self, at: &Place) -> Result<Velocity, FlowError> {
        self.flow.velocity(at)
    }

    fn glide(&self, from: &Place, time: f64) -> Result<(Place, Derivatives), FlowError> {
        let glide = || self.flow.glide(from, time);
        self.tape.recall(&(self.r, from, time), glide)
    }

    fn touch(&self, at: &Place, contact: usize) -> Result<Option<[f64; 2]>, FlowError> {
        self.flow.touch(at, contact)
    }

    fn margins(&self, at: &Place) -> Vec<(usize, f64)> {
        self.flow.margins(at)
    }

    fn speeds(&self, state: &[f64]) -> Vec<f64> {
        self.flow.speeds(state)
    }

    fn check(&self, at: &Place) -> Result<(), FlowError> {
        self.flow.check(at)
    }

    fn read(&self, at: &Place) -> Result<Reading, FlowError> {
        self.flow.read(at)
    }

    fn contacts(&self, at: &Place) -> Result<Contacts, FlowError> {
        self.flow.contacts(at)
    }
}

#[cfg(test)]
mod tests;
