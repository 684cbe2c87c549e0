//! `reproduce`: what a program may do of its own, and does without a command.

use std::error::Error;
use std::path::{Path, PathBuf};

use clap::ArgMatches;

use super::failure::Failure;
use super::output::prepare;
use super::{App, arguments, usage};

/// Writes a report to a folder; quietly if the flag says so.
pub type Reproduction = fn(folder: &Path, quiet: bool) -> Result<(), Box<dyn Error>>;

pub(super) fn perform(app: &App, options: &ArgMatches) -> Result<(), Failure> {
    let Some(reproduction) = app.reproduction else {
        let command = arguments::command(app, None);
        return Err(Failure::usage(usage::no_command("", &command)));
    };
    let folder = options.get_one::<PathBuf>("out");
    let folder = folder.map_or(Path::new("report"), PathBuf::as_path);
    prepare(folder)?;
    reproduction(folder, options.get_flag("quiet"))
        .map_err(|error| Failure::failed(error.to_string()))
}
