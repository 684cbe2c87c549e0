//! What shares of a list have left in a folder, put together.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::failure::Failure;
use super::finding::{Finding, Known};
use super::interrupt::ENDING;
use super::question::Question;
use super::resume::peruse;
use crate::study::{Rows, Share};

/// The name of the file of a share.
pub(super) fn file_of(name: &str, share: Share) -> String {
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

/// Takes in what all shares have found, each item once.
pub(super) fn merge<T: Finding>(
    known: &mut Known<T>,
    folder: &Path,
    name: &str,
    question: &Question,
    (rows, partial): (Rows, bool),
) -> Result<(), Failure> {
    let (mut troubles, mut shares) = (Vec::new(), Vec::new());
    for (path, _, share) in left(folder)?.into_iter().filter(|(_, of, _)| of == name) {
        let mut differs = None;
        let read = peruse(&path, &|asked| question.same(asked), &mut |finding| {
            let (number, agrees) = known.take(finding)?;
            differs = differs.or((!agrees).then_some(number));
            Some(())
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
    troubles.extend(absent(&known.found, rows, &shares));
    if !troubles.is_empty() && !partial {
        let all = troubles.join("; ");
        return Err(Failure::failed(format!(
            "{all}; `--partial` answers without it"
        )));
    }
    Ok(())
}

/// What is missing, by the shares whose it is.
fn absent<T>(found: &BTreeMap<usize, T>, rows: Rows, shares: &[Share]) -> Vec<String> {
    let Some(of) = shares.iter().map(Share::of).max() else {
        return vec!["no share has left anything".to_owned()];
    };
    let of_share = |number| {
        let share = Share::new(number, of)?;
        let all: Vec<usize> = share
            .items(rows)
            .filter(|item| !found.contains_key(item))
            .collect();
        let first = all.first()?;
        Some(format!(
            "share {share} misses {} items, the first number {first}",
            all.len()
        ))
    };
    (1..=of).filter_map(of_share).collect()
}
