//! `--resume` of what is followed: the passages of its computation, noted as they end, and read when it is gone through again.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::arguments::Resume;
use super::failure::Failure;
use super::interrupt;
use super::output::Output;
use super::question::Question;
use super::resume::Notes;
use crate::motion::Tape;
use crate::study::System;

/// The passages of a command.
pub(super) struct Passages {
    known: Vec<Vec<u8>>,
    notes: Arc<Mutex<Notes>>,
}

impl Passages {
    /// No passages yet, or with `--resume` those that are there.
    ///
    /// # Errors
    /// There is no folder to resume in, or what is there belongs to another question.
    pub(super) fn open(
        output: &Output,
        resume: &Resume,
        name: &str,
        question: &Question,
    ) -> Result<Self, Failure> {
        let mut known = Vec::new();
        let mut recall = |record: &[u8]| {
            known.push(record.to_vec());
            Some(())
        };
        let notes = Notes::open(output, resume, name, question, &mut recall)?;
        Ok(Self {
            known,
            notes: Arc::new(Mutex::new(notes)),
        })
    }

    /// The same system, going through what is known and noting what is not.
    pub(super) fn recorded(&mut self, system: &System) -> System {
        let notes = self.notes.clone();
        if !locked(&notes).are_kept() {
            return system.clone();
        }
        let note = move |record: &[u8]| {
            // What is computed to come to an end is not what will be computed to go on.
            if !interrupt::asked() {
                locked(&notes).add(Some(record.to_vec()));
            }
        };
        system.recorded(Tape::new(std::mem::take(&mut self.known), Box::new(note)))
    }

    /// The command is done: they are needed no more.
    pub(super) fn discard(self) {
        locked(&self.notes).discard();
    }
}

fn locked(notes: &Mutex<Notes>) -> MutexGuard<'_, Notes> {
    notes.lock().unwrap_or_else(PoisonError::into_inner)
}
