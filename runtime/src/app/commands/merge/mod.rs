//! `merge`: the answer of a list whose shares were done apart.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use clap::Args;

use crate::app::arguments::View;
use crate::app::failure::{Failure, refuse};
use crate::app::question::Question;
use crate::app::resume::peruse;
use crate::app::shares::left;

/// Put together what the shares of a command have left in a folder
#[derive(Debug, Clone, Args)]
#[command(
    after_help = "The answer is the same, byte by byte, as that of one run without `--shard`, whatever the number of \
                  shares, their order and their interruptions. What is missing is named, and the exit code is 1 then"
)]
pub(in crate::app) struct Arguments {
    /// The folder that `--out` named
    folder: Option<PathBuf>,
    /// Where the answer is written; to the same folder if nothing is said
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Answer without what is missing
    #[arg(long)]
    partial: bool,
    #[command(flatten)]
    view: View,
}

/// The words that ask the question of the shares again, to be answered from what they have left.
pub(in crate::app) fn words(arguments: &Arguments) -> Result<Vec<OsString>, Failure> {
    let Some(folder) = &arguments.folder else {
        return refuse!(
            "`merge` needs the folder in which shares have left what they found: `merge DIR`"
        );
    };
    let Some(words) = asked(folder)? else {
        return refuse!("no share has left anything in `{}`", folder.display());
    };
    let mut words: Vec<OsString> = words.into_iter().map(Into::into).collect();
    words.insert(0, "stickslip".into());
    let out = arguments.out.as_ref().unwrap_or(folder);
    words.extend(["--merged".into(), folder.into(), "--out".into(), out.into()]);
    let flags = [
        ("--partial", arguments.partial),
        ("--json", arguments.view.json),
        ("--quiet", arguments.view.quiet),
    ];
    words.extend(flags.iter().filter(|flag| flag.1).map(|flag| flag.0.into()));
    Ok(words)
}

/// The words with which the shares in a folder were asked; those of the first that can be read.
fn asked(folder: &Path) -> Result<Option<Vec<String>>, Failure> {
    let files = left(folder)?;
    let words = files.iter().find_map(|(path, ..)| {
        let words = std::cell::OnceCell::new();
        let take = |asked: &Question| {
            let _ = words.set(asked.words());
            Ok(())
        };
        let _ = peruse(path, &take, &mut |_| Some(()));
        words.into_inner().flatten()
    });
    Ok(words)
}
