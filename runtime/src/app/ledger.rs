//! Lists of items that may be shared between machines: what each share has found, in a file of its own.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use clap::Args;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::json;

use super::arguments::Resume;
use super::failure::{Failure, refuse};
use super::interrupt::{self, ENDING};
use super::output::Output;
use super::question::Question;
use super::resume::{Notes, peruse};
use super::shard::Shard;
use super::values::{Reading, counted};
use crate::study::{Item, List, Share};

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

/// A list and the file that keeps what is found of it.
pub(super) struct Ledger<T> {
    pub(super) list: List<T>,
    name: String,
    share: Option<Share>,
    notes: Mutex<Notes>,
}

impl<T: Serialize + DeserializeOwned + Clone + Send + Sync> Ledger<T> {
    /// The list of `count` items of a question, with what is known of it.
    ///
    /// # Errors
    /// What is known belongs to another question, or is not as it was written; or a share has no folder.
    pub(super) fn open(
        output: &Output,
        sharing: &Sharing,
        name: &str,
        question: &Question,
        count: usize,
    ) -> Result<Self, Failure> {
        let share = sharing.shard.as_ref().map(|shard| shard.0);
        if share.is_some() && !output.is_kept() {
            return refuse!("`--shard` leaves what it finds in a folder: name it with `--out DIR`");
        }
        let question = question.clone().of_items(count);
        let mut known = BTreeMap::new();
        let notes = if let Some(folder) = &sharing.merged {
            known = merged(folder, name, &question, (count, sharing.partial))?;
            Notes::none()
        } else {
            let file = share.map_or_else(|| name.to_owned(), |share| file_of(name, share));
            let mut read = |finding: &[u8]| {
                let (number, found): (usize, T) = postcard::from_bytes(finding).ok()?;
                known.insert(number, found);
                Some(())
            };
            Notes::open(output, &sharing.resume, &file, &question, &mut read)?
        };
        if share.is_some() {
            interrupt::is_continued();
        }
        Ok(Self {
            list: List {
                count,
                share: share.unwrap_or(Share::WHOLE),
                threads: sharing.threads,
                known,
                closed: sharing.merged.is_some(),
            },
            name: name.to_owned(),
            share,
            notes: Mutex::new(notes),
        })
    }

    /// Notes an item.
    pub(super) fn take(&self, item: &Item<'_, T>) {
        if !item.known {
            let mut notes = self.notes.lock().unwrap_or_else(PoisonError::into_inner);
            notes.add(postcard::to_allocvec(&(item.number, item.found)).ok());
        }
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
        let there = self.list.count - missing;
        let of = self.list.share.items(self.list.count).count();
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

/// The name of the file of a share.
fn file_of(name: &str, share: Share) -> String {
    format!("{name}.{}-of-{}", share.number(), share.of())
}

/// The files in a folder that shares have left, with the names of their commands, in the order of their numbers.
pub(super) fn left(folder: &Path) -> Result<Vec<(PathBuf, String, Share)>, Failure> {
    let unread = |error: std::io::Error| {
        Failure::usage(format!("`{}` cannot be read: {error}", folder.display()))
    };
    let mut all = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(unread)? {
        let path = entry.map_err(unread)?.path();
        let file = path.file_name().and_then(|name| name.to_str());
        if let Some((name, share)) = file.and_then(named) {
            let name = name.to_owned();
            all.push((path, name, share));
        }
    }
    all.sort_by_key(|(_, name, share)| (name.clone(), share.of(), share.number()));
    Ok(all)
}

/// The command and the share to which a file belongs.
fn named(file: &str) -> Option<(&str, Share)> {
    let (name, share) = file
        .strip_suffix(ENDING)?
        .strip_suffix('.')?
        .split_once('.')?;
    let (number, of) = share.split_once("-of-")?;
    let share = Share::new(number.parse().ok()?, of.parse().ok()?)?;
    (file_of(name, share) == format!("{name}.{number}-of-{of}")).then_some((name, share))
}

/// What all shares have found, each item once.
fn merged<T: DeserializeOwned>(
    folder: &Path,
    name: &str,
    question: &Question,
    (count, partial): (usize, bool),
) -> Result<BTreeMap<usize, T>, Failure> {
    let mut raw: BTreeMap<usize, Vec<u8>> = BTreeMap::new();
    let mut troubles = Vec::new();
    let mut shares = Vec::new();
    for (path, _, share) in left(folder)?.into_iter().filter(|(_, of, _)| of == name) {
        let mut differs = None;
        let read = peruse(&path, &|asked| question.same(asked), &mut |finding| {
            let (number, _) = postcard::take_from_bytes::<usize>(finding).ok()?;
            let old = raw.insert(number, finding.to_vec());
            differs = differs.or(old.filter(|old| old != finding).map(|_| number));
            (number < count).then_some(())
        });
        if let Some(number) = differs {
            return Err(Failure::failed(format!(
                "item {number} of {} is not what another share has found: the machines differ, or the program does",
                path.display()
            )));
        }
        match read {
            Ok(()) => shares.push(share),
            Err(reason) => troubles.push(format!("{} {reason}", path.display())),
        }
    }
    troubles.extend(absent(&raw, count, &shares));
    if !troubles.is_empty() && !partial {
        let all = troubles.join("; ");
        return Err(Failure::failed(format!(
            "{all}; `--partial` answers without it"
        )));
    }
    let one = |(number, finding): (usize, Vec<u8>)| {
        let (_, found): (usize, T) = postcard::from_bytes(&finding).ok()?;
        Some((number, found))
    };
    Ok(raw.into_iter().filter_map(one).collect())
}

/// What is missing, by the shares whose it is.
fn absent(raw: &BTreeMap<usize, Vec<u8>>, count: usize, shares: &[Share]) -> Vec<String> {
    let Some(of) = shares.iter().map(Share::of).max() else {
        return vec!["no share has left anything".to_owned()];
    };
    let of_share = |number| {
        let share = Share::new(number, of)?;
        let all: Vec<usize> = share
            .items(count)
            .filter(|item| !raw.contains_key(item))
            .collect();
        let first = all.first()?;
        Some(format!(
            "share {share} misses {} items, the first number {first}",
            all.len()
        ))
    };
    (1..=of).filter_map(of_share).collect()
}
