//! Lists of items that may be shared between machines: what each share has found, in a file of its own.

use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

use clap::Args;
use serde_json::json;

use super::arguments::Resume;
use super::failure::{Failure, refuse};
use super::finding::{Finding, Known};
use super::interrupt;
use super::journal::Journal;
use super::output::Output;
use super::progress::Progress;
use super::question::Question;
use super::request::Request;
use super::resume::Notes;
use super::shard::Shard;
use super::shares::{file_of, merge};
use super::spreadsheet::Head;
use super::values::{Reading, counted};
use crate::study::{Item, List, Rows, Share, StudyError, Watch};

/// How a list of items is worked through.
#[derive(Debug, Clone, Args)]
pub(super) struct Sharing {
    /// How many threads; all cores if nothing is said
    #[arg(long, value_name = "N", value_parser = counted::<1, 4096>())]
    threads: Option<usize>,
    /// Only share I of N: `3/7`; `auto` in a job array of Slurm, `auto/7` there or in one of HyperQueue. `merge` puts the shares together
    #[arg(long, value_name = "I/N", value_parser = Reading(Shard::read))]
    shard: Option<Shard>,
    #[command(flatten)]
    resume: Resume,
    /// Answer from what the shares have left in this folder
    #[arg(long, value_name = "DIR", hide = true)]
    merged: Option<PathBuf>,
    /// Answer without what is missing
    #[arg(long, hide = true)]
    partial: bool,
}

impl Sharing {
    /// The same on one thread, if nothing is said.
    pub(super) fn on_one_thread(&self) -> Self {
        Self {
            threads: self.threads.or(Some(1)),
            ..self.clone()
        }
    }
}

/// A list and the file that keeps what is found of it.
pub(super) struct Ledger<T> {
    list: List<T>,
    rows: Rows,
    name: String,
    share: Option<Share>,
    notes: Mutex<Notes>,
}

impl<T: Finding> Ledger<T> {
    /// The list of a question, with what is known of it.
    ///
    /// # Errors
    /// What is known belongs to another question, or is not as it was written; or a share has no folder.
    pub(super) fn open(
        asked: &Request<'_>,
        sharing: &Sharing,
        name: &str,
        question: Question,
        rows: Rows,
    ) -> Result<Self, Failure> {
        let (output, order) = (&asked.output, asked.info.states.len());
        let share = sharing.shard.as_ref().map(|shard| shard.0);
        if share.is_some() && !output.is_kept() {
            return refuse!("`--shard` leaves what it finds in a folder: name it with `--out DIR`");
        }
        if share.is_some() {
            interrupt::is_continued();
        }
        interrupt::hear();
        let question = question.of_rows(rows);
        let mut known = Known::of(rows, order);
        let notes = if let Some(folder) = &sharing.merged {
            merge(&mut known, folder, name, &question, (rows, sharing.partial))?;
            Notes::none()
        } else {
            let file = share.map_or_else(|| name.to_owned(), |share| file_of(name, share));
            let mut read = |finding: &[u8]| known.take(finding).map(drop);
            Notes::open(output, &sharing.resume, &file, &question, &mut read)?
        };
        Ok(Self {
            list: List {
                share: share.unwrap_or(Share::WHOLE),
                threads: sharing.threads,
                known: known.found,
                closed: sharing.merged.is_some(),
            },
            rows,
            name: name.to_owned(),
            share,
            notes: Mutex::new(notes),
        })
    }

    /// What a study finds of the list: each item is noted, and told of on the way.
    ///
    /// # Errors
    /// The study has no answer.
    pub(super) fn answer<R>(
        &self,
        asked: &Request<'_>,
        beginning: &'static str,
        tell: &(dyn Fn(&Item<'_, T>) -> String + Sync),
        study: impl FnOnce(&List<T>, Watch<'_, T>) -> Result<R, StudyError>,
    ) -> Result<R, Failure> {
        let progress = Progress::along(&asked.output, beginning);
        let watch = |item: Item<'_, T>| {
            self.take(&item);
            progress.reach(item.done, tell(&item))
        };
        asked.got(study(&self.list, &watch))
    }

    /// A table in the folder that grows as items are found; a share has none.
    pub(super) fn journal(&self, output: &Output, name: &str, head: &[Head]) -> Journal {
        match self.share {
            Some(_) => Journal::new(None, head),
            None => output.journal(name, head),
        }
    }

    /// Notes an item.
    fn take(&self, item: &Item<'_, T>) {
        if !item.known {
            let mut notes = self.notes.lock().unwrap_or_else(PoisonError::into_inner);
            notes.add(postcard::to_allocvec(&(item.number, item.found)).ok());
        }
    }

    /// On how many threads it is done, if that was said.
    pub(super) const fn threads(&self) -> Option<usize> {
        self.list.threads
    }

    /// Whether only a share is done, and there is no answer yet.
    pub(super) const fn is_shared(&self) -> bool {
        self.share.is_some()
    }

    /// The end of the work, of which `missing` items of the list are not there; whole, its notes are needed no more.
    ///
    /// # Errors
    /// It was interrupted.
    pub(super) fn close(self, output: &Output, missing: usize) -> Result<(), Failure> {
        let there = self.rows.items() - missing;
        let of = self.list.share.count(self.rows);
        let notes = self
            .notes
            .into_inner()
            .unwrap_or_else(PoisonError::into_inner);
        let Some(share) = self.share else {
            if missing > 0 && !self.list.closed {
                return Err(output.interrupted(&format!("{there} of {of} items were found")));
            }
            notes.discard();
            return Ok(());
        };
        let said = format!("share {share} of `{}`: {there} of {of} items", self.name);
        if !notes.are_kept() {
            return Err(Failure::failed(format!(
                "{said}, but its notes could not be written"
            )));
        }
        if there < of {
            return Err(Failure::continued(&said));
        }
        let document = json!({ "share": share.to_string(), "of": self.name, "items": there });
        output.tell(&format!("{said}\n"), &document)
    }
}
