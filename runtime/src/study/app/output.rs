//! Where answers go: stdout and a folder.

use std::fmt::Display;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use clap::ArgMatches;
use serde::Serialize;

use super::failure::Failure;
use super::spreadsheet::Spreadsheet;

/// What the user wants to see, and where.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Output {
    pub(super) json: bool,
    pub(super) quiet: bool,
    pub(super) out: Option<PathBuf>,
}

impl Output {
    /// Reads the options; the folder is there and can be written to afterwards.
    pub(super) fn new(options: &ArgMatches) -> Result<Self, Failure> {
        let flag = |name| options.try_get_one::<bool>(name).ok().flatten() == Some(&true);
        let out = options
            .try_get_one::<PathBuf>("out")
            .ok()
            .flatten()
            .cloned();
        if let Some(folder) = &out {
            prepare(folder)?;
        }
        Ok(Self {
            json: flag("json"),
            quiet: flag("quiet"),
            out,
        })
    }

    /// Prints an answer, as text or as JSON, and writes it to the folder.
    pub(super) fn deliver(
        &self,
        name: &str,
        text: &str,
        document: &impl Serialize,
        sheets: &[(&str, Spreadsheet)],
    ) -> Result<(), Failure> {
        let document = json(document)?;
        let mut text = text.to_owned();
        if let Some(folder) = &self.out {
            for (sheet, content) in sheets {
                write(&folder.join(format!("{sheet}.csv")), &content.text()?)?;
            }
            write(&folder.join(format!("{name}.json")), &document)?;
            text.push_str(&format!("\nwritten to {}\n", folder.display()));
        }
        print(if self.json { &document } else { &text })
    }

    /// Says something beside the answer.
    pub(super) fn note(&self, note: impl Display) {
        if !self.quiet {
            let _ = writeln!(std::io::stderr(), "{note}");
        }
    }
}

/// Makes a folder, and makes sure before any work that files can be written to it.
pub(super) fn prepare(folder: &Path) -> Result<(), Failure> {
    let refused = |error: std::io::Error| {
        Failure::usage(format!(
            "nothing can be written to `--out {}`: {error}",
            folder.display()
        ))
    };
    std::fs::create_dir_all(folder).map_err(refused)?;
    let probe = folder.join(format!(".stickslip-{}", std::process::id()));
    std::fs::write(&probe, "").map_err(refused)?;
    std::fs::remove_file(&probe).map_err(refused)
}

fn json(document: &impl Serialize) -> Result<String, Failure> {
    serde_json::to_string_pretty(document)
        .map(|text| text + "\n")
        .map_err(|error| Failure::failed(format!("the answer cannot be written as JSON: {error}")))
}

fn write(path: &Path, text: &str) -> Result<(), Failure> {
    std::fs::write(path, text)
        .map_err(|error| Failure::failed(format!("cannot write {}: {error}", path.display())))
}

/// Prints on stdout; a reader who has left is no error.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    let mut stdout = std::io::stdout().lock();
    match stdout
        .write_all(text.as_bytes())
        .and_then(|()| stdout.flush())
    {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::failed(format!("cannot write the answer: {error}")))
        }
        _ => Ok(()),
    }
}
