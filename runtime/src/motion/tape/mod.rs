//! Passages that are kept, so that a computation which was ended can be gone through again in no time.
//!
//! A branch is more than its points: steps that were too long and orbits between two others decide how it goes on. But
//! all of that follows from where its passages end. A computation that is done again, with those passages read instead of
//! integrated, comes in the same way to where it was ended, and goes on from there to the same bits.

mod shape;

use std::collections::VecDeque;
use std::fmt;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use serde::Serialize;
use serde::de::DeserializeOwned;

use super::{Contacts, Derivatives, Family, Flow, Flows, Modes, Passage, Place, Reading, Velocity};
use crate::field::Design;
use crate::field::exact::Mode;
use crate::flow::{FlowError, Want};
use crate::integrate::Tolerance;
use crate::model::Values;
use shape::Shaped;

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

    /// What is asked by `key` of a motion from `from`: as it is known, or computed and noted.
    ///
    /// A failure is noted without its reason: it is found again where the computation is gone through again.
    fn recall<T: Serialize + DeserializeOwned + Shaped, E>(
        &self,
        from: &Place,
        key: impl Serialize,
        compute: impl FnOnce() -> Result<T, E>,
    ) -> Result<T, E> {
        let mut record = postcard::to_allocvec(&(from, key)).unwrap_or_default();
        let known = self.known().records.pop_front();
        if let Some(known) = known {
            let found = known.strip_prefix(record.as_slice());
            match found.map(|found| (found, postcard::take_from_bytes::<T>(found))) {
                Some(([], _)) => return compute(),
                Some((_, Ok((found, [])))) if found.is_like(from) => return Ok(found),
                _ => self.stray(),
            }
        }
        let found = compute();
        if let Ok(found) = &found {
            // What cannot be written is computed again.
            record.extend(postcard::to_allocvec(found).unwrap_or_default());
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
    pub(super) family: Family,
    pub(super) tape: Arc<Tape>,
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

/// What a taped flow answers as the flow itself does.
macro_rules! as_it_is {
    ($($name:ident($($told:ident: $type:ty),*) -> $answer:ty;)*) => {$(
        fn $name(&self, $($told: $type),*) -> $answer {
            self.flow.$name($($told),*)
        }
    )*};
}

impl Flow for TapedFlow {
    as_it_is! {
        order() -> usize;
        phase() -> Option<usize>;
        values(state: &[f64]) -> Values;
        place(state: &[f64]) -> Result<Place, FlowError>;
        place_in(state: &[f64], modes: &[Mode]) -> Result<Place, FlowError>;
        velocity(at: &Place) -> Result<Velocity, FlowError>;
        touch(at: &Place, contact: usize) -> Result<Option<[f64; 2]>, FlowError>;
        hold(at: &Place, contact: usize) -> Result<Option<[f64; 2]>, FlowError>;
        loosening(state: &[f64], contact: usize) -> f64;
        kick(at: &Place, contact: usize) -> Result<Option<Vec<f64>>, FlowError>;
        margins(at: &Place) -> Vec<(usize, f64)>;
        speeds(state: &[f64]) -> Vec<f64>;
        stop(state: usize) -> f64;
        loosened(modes: Modes, speeds: &[f64]) -> Modes;
        pinned(modes: Modes, state: &[f64]) -> Modes;
        check(at: &Place) -> Result<(), FlowError>;
        read(at: &Place) -> Result<Reading, FlowError>;
        contacts(at: &Place) -> Result<Contacts, FlowError>;
    }

    fn advance(&self, from: &Place, time: f64, want: Want) -> Result<Passage, FlowError> {
        let advance = || self.flow.advance(from, time, want);
        self.tape.recall(from, (self.r, time, want), advance)
    }

    fn glide(&self, from: &Place, time: f64) -> Result<(Place, Derivatives), FlowError> {
        let glide = || self.flow.glide(from, time);
        self.tape.recall(from, (self.r, time), glide)
    }
}

#[cfg(test)]
mod tests;
