//! `--resume` of what is followed: the passages of its computation, noted as they end, and read when it is gone through again.

use std::cell::RefCell;

use super::arguments::Resume;
use super::failure::Failure;
use super::interrupt;
use super::output::Output;
use super::resume::{Notes, Question};
use crate::flow::Tape;

/// The passages of a command.
pub(super) struct Passages {
    known: Vec<Vec<u8>>,
    notes: RefCell<Notes>,
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
            notes: RefCell::new(notes),
        })
    }

    /// Computes with a tape of what is known, and notes what is not.
    pub(super) fn through<R>(&mut self, compute: impl FnOnce(&Tape<'_>) -> R) -> R {
        let note = |record: &[u8]| {
            // What is computed to come to an end is not what will be computed to go on.
            if !interrupt::asked() {
                self.notes.borrow_mut().add(Some(record.to_vec()));
            }
        };
        if self.notes.borrow().are_kept() {
            compute(&Tape::new(std::mem::take(&mut self.known), &note))
        } else {
            compute(&Tape::blank())
        }
    }

    /// The command is done: they are needed no more.
    pub(super) fn discard(self) {
        self.notes.into_inner().discard();
    }
}
