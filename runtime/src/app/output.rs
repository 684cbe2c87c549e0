//! Where what a command has found goes: to stdout and to a folder.

use std::fmt::Display;
use std::io::Write;
use std::path::{Path, PathBuf};

use serde::Serialize;
use serde_json::Value;

use super::answer::Answer;
use super::arguments::{Destination, View};
use super::document::{value_of, versioned};
use super::failure::Failure;
use super::interrupt::{growing, way_out};
use super::journal::Journal;
use super::print::print;
use super::spreadsheet::{Head, Spreadsheet, csv};
use super::width::{fitted, wrapped};
use crate::report::whole;
use crate::study::Ended;

/// What the user wants to see, and where.
#[derive(Debug, Clone)]
pub(super) struct Output {
    view: View,
    out: Option<PathBuf>,
    /// What is asked, for a document that has no answer.
    subject: Value,
}

impl From<&View> for Output {
    fn from(view: &View) -> Self {
        Self {
            view: view.clone(),
            out: None,
            subject: Value::Null,
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
            subject: Value::Null,
        })
    }

    /// The same, for a question with these fields.
    pub(super) fn about(self, subject: impl Serialize) -> Self {
        let subject = value_of(subject);
        Self { subject, ..self }
    }

    /// What is printed of a question that was ended before it had an answer.
    pub(super) fn last_words(&self) -> String {
        if !(self.view.json && self.subject.is_object()) {
            return String::new();
        }
        let mut subject = versioned(self.subject.clone());
        subject["ended"] = "interrupted".into();
        json(&subject).unwrap_or_default()
    }

    /// Whether there is a folder.
    pub(super) fn is_kept(&self) -> bool {
        self.out.is_some()
    }

    /// Whether more is wanted than a few words.
    pub(super) fn is_wanted_whole(&self) -> bool {
        self.view.json || self.is_kept()
    }

    /// Whether there shall be neither progress nor notes.
    pub(super) fn is_quiet(&self) -> bool {
        self.view.quiet
    }

    /// Prints an answer, as text or as JSON, and writes it to the folder with its pictures.
    pub(super) fn deliver(&self, answer: &Answer<'_>) -> Result<(), Failure> {
        // A full disk costs no answer.
        let written = self.keep(answer);
        let told = if self.view.json {
            json(&answer.document())?
        } else {
            let place = self.out.iter().filter(|_| written.is_ok());
            let place = place.map(|folder| {
                let files = wrapped(&answer.files().join(", "), "  ");
                format!("\nwritten to {}:\n{files}", folder.display())
            });
            fitted(&answer.text()) + &place.collect::<String>()
        };
        print(&told).and(written)
    }

    /// Writes to the folder, if there is one, what is found beside the answer.
    pub(super) fn keep(&self, answer: &Answer<'_>) -> Result<(), Failure> {
        let mut folders = self.out.iter();
        folders.try_for_each(|folder| store(folder, answer, &self.subject))
    }

    /// The place of a file in the folder, if there is one.
    pub(super) fn path(&self, name: &str) -> Option<PathBuf> {
        self.out.as_ref().map(|folder| folder.join(name))
    }

    /// A table in the folder, if there is one, that grows row by row.
    pub(super) fn journal(&self, name: &str, head: &[Head]) -> Journal {
        Journal::new(self.path(&format!("{name}.csv")), head)
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

    /// Says why `what` ended before its range did, after the answer; `found` is said where that was an interruption.
    ///
    /// # Errors
    /// It did not end for a reason of its own.
    pub(super) fn close(&self, what: &str, ended: &Ended, found: &str) -> Result<(), Failure> {
        if ended.is_interrupted() {
            return Err(self.interrupted(found));
        }
        let reason = format!("the {what} ended: {}", ended.reason);
        if !ended.is_located() {
            return Err(Failure::failed(reason));
        }
        if !ended.is_whole() {
            self.note(reason);
        }
        Ok(())
    }

    /// Prints what stands for an answer, as text or as JSON.
    pub(super) fn tell(&self, text: &str, document: &Value) -> Result<(), Failure> {
        if self.view.json {
            return print(&json(document)?);
        }
        print(text)
    }

    /// Says something beside the answer.
    pub(super) fn note(&self, note: impl Display) {
        if !self.view.quiet {
            let _ = writeln!(std::io::stderr(), "{note}");
        }
    }
}

/// Writes all forms of an answer to a question with these fields.
fn store(folder: &Path, answer: &Answer<'_>, subject: &Value) -> Result<(), Failure> {
    let file = |name: &str, ending: &str| folder.join(format!("{name}.{ending}"));
    for (name, figure) in &answer.figures {
        let (figure, path) = (figure(), file(name, "pdf"));
        write(&file(name, "svg"), figure.svg())?;
        write(
            &path,
            figure.pdf().map_err(|error| unwritten(&path, &error))?,
        )?;
    }
    for (name, sheet) in &answer.sheets {
        let sheet = sheet();
        write(&file(name, "csv"), csv(sheet.lines())?)?;
        columnar(&file(name, "parquet"), &sheet, subject)?;
    }
    write(&file(answer.name, "json"), &json(&answer.document())?)
}

#[cfg(feature = "parquet")]
fn columnar(path: &Path, sheet: &Spreadsheet, subject: &Value) -> Result<(), Failure> {
    let content = super::parquet::parquet(sheet, subject);
    write(path, content.map_err(|error| unwritten(path, &error))?)
}

#[cfg(not(feature = "parquet"))]
const fn columnar(_: &Path, _: &Spreadsheet, _: &Value) -> Result<(), Failure> {
    Ok(())
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
fn write(path: &Path, content: impl AsRef<[u8]>) -> Result<(), Failure> {
    whole::write(path, content).map_err(|error| unwritten(path, &error))
}

fn unwritten(path: &Path, error: &dyn Display) -> Failure {
    Failure::failed(format!("cannot write {}: {error}", path.display()))
}
