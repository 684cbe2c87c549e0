//! `status`: how far the shares of a command have come.

use std::cell::OnceCell;
use std::collections::BTreeSet;
use std::path::PathBuf;

use clap::Args;
use serde_json::json;

use crate::app::answer::Answer;
use crate::app::arguments::Destination;
use crate::app::failure::{Failure, refuse};
use crate::app::offer::App;
use crate::app::output::Output;
use crate::app::resume::peruse;
use crate::app::shares::left;
use crate::app::text::{line, table};
use crate::study::{Rows, Share};

/// Say how far the shares in a folder have come
#[derive(Debug, Clone, Args)]
pub(in crate::app) struct Arguments {
    /// The folder that `--out` named
    folder: Option<PathBuf>,
    #[command(flatten)]
    destination: Destination,
}

/// How far a share has come.
struct Progress {
    command: String,
    share: Share,
    done: usize,
    of: usize,
    trouble: Option<String>,
}

pub(in crate::app) fn perform(_: &App, arguments: &Arguments) -> Result<(), Failure> {
    let Some(folder) = &arguments.folder else {
        return refuse!(
            "`status` needs the folder in which shares leave what they find: `status DIR`"
        );
    };
    let all: Vec<Progress> = left(folder)?.into_iter().map(progress).collect();
    if all.is_empty() {
        return refuse!("no share has left anything in `{}`", folder.display());
    }
    let absent = absent(&all);
    let answer = Answer::new(
        "status",
        || describe(&all, &absent),
        || document(&all, &absent),
    );
    Output::open(&arguments.destination)?.deliver(&answer)
}

fn progress((path, command, share): (PathBuf, String, Share)) -> Progress {
    let rows = OnceCell::new();
    let mut items = BTreeSet::new();
    let take = |asked: &crate::app::question::Question| {
        let _ = rows.set(asked.rows());
        Ok(())
    };
    let read = peruse(&path, &take, &mut |finding| {
        let (number, _) = postcard::take_from_bytes::<usize>(finding).ok()?;
        items.insert(number);
        Some(())
    });
    let rows = rows.into_inner().flatten().unwrap_or(Rows::of(0));
    Progress {
        command,
        share,
        done: items.len(),
        of: share.count(rows),
        trouble: read.err(),
    }
}

/// Shares of which there is no file.
fn absent(all: &[Progress]) -> Vec<Share> {
    let of = all.iter().map(|one| one.share.of()).max().unwrap_or(0);
    let shares = (1..=of).filter_map(|number| Share::new(number, of));
    shares
        .filter(|share| all.iter().all(|one| one.share != *share))
        .collect()
}

fn describe(all: &[Progress], absent: &[Share]) -> String {
    let head = ["command", "share", "items", "of", ""].map(str::to_owned);
    let rows = all.iter().map(|one| {
        let verdict = match &one.trouble {
            Some(trouble) => trouble.clone(),
            None if one.done == one.of => "done".to_owned(),
            None => String::new(),
        };
        line([
            one.command.clone(),
            one.share.to_string(),
            one.done.to_string(),
            one.of.to_string(),
            verdict,
        ])
    });
    let missing = absent.iter().map(|share| {
        line([
            String::new(),
            share.to_string(),
            "0".to_owned(),
            String::new(),
            "no file".to_owned(),
        ])
    });
    table(&(line(head) + &rows.chain(missing).collect::<String>()))
}

fn document(all: &[Progress], absent: &[Share]) -> serde_json::Value {
    let shares = all.iter().map(|one| {
        json!({
            "command": one.command, "share": one.share.to_string(), "items": one.done, "of": one.of,
            "trouble": one.trouble,
        })
    });
    json!({
        "shares": shares.collect::<Vec<_>>(),
        "absent": absent.iter().map(Share::to_string).collect::<Vec<_>>(),
    })
}
