//! Where answers go: stdout and a folder.

use std::fmt::Display;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use serde::Serialize;

use super::arguments::{Destination, View};
use super::failure::Failure;
use super::interrupt::{growing, way_out};
use super::journal::Journal;
use super::spreadsheet::{Row, Spreadsheet};
use crate::report::Figure;
use crate::report::whole;
use crate::study::Ended;

/// What the user wants to see, and where.
#[derive(Debug, Clone)]
pub(super) struct Output {
    view: View,
    out: Option<PathBuf>,
}

impl From<&View> for Output {
    fn from(view: &View) -> Self {
        Self {
            view: view.clone(),
            out: None,
        }
    }
}

impl Output {
    /// The folder is there and can be written to afterwards.
    pub(super) fn open(destination: &Destination) -> Result<Self, Failure> {
        let out = destination.out.clone();
        out.as_deref().map_or(Ok(()), prepare)?;
        Ok(Self {
            view: destination.view.clone(),
            out,
        })
    }

    /// Whether there is a folder.
    pub(super) fn is_kept(&self) -> bool {
        self.out.is_some()
    }

    /// Whether there shall be neither progress nor notes.
    pub(super) fn is_quiet(&self) -> bool {
        self.view.quiet
    }

    /// Prints an answer, as text or as JSON, and writes it to the folder.
    pub(super) fn deliver(
        &self,
        name: &str,
        text: &str,
        document: &impl Serialize,
        sheets: &[(impl AsRef<str>, Spreadsheet)],
    ) -> Result<(), Failure> {
        let document = json(document)?;
        let mut text = text.to_owned();
        let mut written = Ok(());
        if let Some(folder) = &self.out {
            written = store(folder, name, &document, sheets);
            if written.is_ok() {
                text.push_str(&format!("\nwritten to {}\n", folder.display()));
            }
        }
        // A full disk costs no answer.
        print(if self.view.json { &document } else { &text }).and(written)
    }

    /// Writes to the folder, if there is one, what is found beside the answer.
    pub(super) fn keep(
        &self,
        name: &str,
        document: &impl Serialize,
        sheets: &[(impl AsRef<str>, Spreadsheet)],
    ) -> Result<(), Failure> {
        let document = json(document)?;
        let mut folders = self.out.iter();
        folders.try_for_each(|folder| store(folder, name, &document, sheets))
    }

    /// The place of a file in the folder, if there is one.
    pub(super) fn path(&self, name: &str) -> Option<PathBuf> {
        self.out.as_ref().map(|folder| folder.join(name))
    }

    /// A table in the folder, if there is one, that grows row by row.
    pub(super) fn journal(&self, name: &str, head: Row) -> Journal {
        Journal::new(self.path(&format!("{name}.csv")), head)
    }

    /// Writes figures to the folder, if there is one, each under its name.
    pub(super) fn draw<'a>(
        &self,
        figures: impl IntoIterator<Item = (&'a str, Figure)>,
    ) -> Result<(), Failure> {
        for (folder, (name, figure)) in self.out.iter().cycle().zip(figures) {
            write(&folder.join(format!("{name}.svg")), &figure.svg())?;
        }
        Ok(())
    }

    /// That a command has come to its end before it was done, and what is there.
    pub(super) fn interrupted(&self, found: &str) -> Failure {
        let place = match &self.out {
            Some(folder) => format!(", and all of it is in {}", folder.display()),
            None => String::new(),
        };
        let way_out = way_out(&growing());
        Failure::interrupted(&format!("{found}{place}{way_out}"))
    }

    /// Says why `what` ended, after the answer; `found` is said where that was an interruption.
    ///
    /// # Errors
    /// It did not end for a reason of its own.
    pub(super) fn close(&self, what: &str, ended: &Ended, found: &str) -> Result<(), Failure> {
        if ended.is_interrupted() {
            return Err(self.interrupted(found));
        }
        let reason = format!("the {what} ended, {}: {}", ended.word(), ended.reason);
        if !ended.is_located() {
            return Err(Failure::failed(reason));
        }
        self.note(reason);
        Ok(())
    }

    /// Says something beside the answer.
    pub(super) fn note(&self, note: impl Display) {
        if !self.view.quiet {
            let _ = writeln!(std::io::stderr(), "{note}");
        }
    }
}

fn store(
    folder: &Path,
    name: &str,
    document: &str,
    sheets: &[(impl AsRef<str>, Spreadsheet)],
) -> Result<(), Failure> {
    for (sheet, content) in sheets {
        let sheet = sheet.as_ref();
        write(&folder.join(format!("{sheet}.csv")), &content.text()?)?;
    }
    write(&folder.join(format!("{name}.json")), document)
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

/// Writes a file whole or not at all.
fn write(path: &Path, text: &str) -> Result<(), Failure> {
    whole::write(path, text)
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
