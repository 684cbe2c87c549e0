//! Where answers go: stdout and a folder.

use std::fmt::Display;
use std::fs::File;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use clap::ArgMatches;
use serde::Serialize;

use super::failure::Failure;
use super::spreadsheet::Spreadsheet;
use crate::study::report::Figure;

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
        let mut written = Ok(());
        if let Some(folder) = &self.out {
            written = store(folder, name, &document, sheets);
            if written.is_ok() {
                text.push_str(&format!("\nwritten to {}\n", folder.display()));
            }
        }
        // A full disk costs no answer.
        print(if self.json { &document } else { &text }).and(written)
    }

    /// A table in the folder, if there is one, that grows row by row.
    pub(super) fn journal(&self, name: &str) -> Journal {
        Journal {
            path: self
                .out
                .as_ref()
                .map(|folder| folder.join(format!("{name}.csv"))),
            file: None,
        }
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

    /// Says something beside the answer.
    pub(super) fn note(&self, note: impl Display) {
        if !self.quiet {
            let _ = writeln!(std::io::stderr(), "{note}");
        }
    }
}

/// A table that is there as far as it has come, whatever ends the program.
pub(super) struct Journal {
    path: Option<PathBuf>,
    file: Option<File>,
}

impl Journal {
    /// Adds the rows of a table that has the same head; once that fails, no more: the whole is written at the end.
    pub(super) fn add(&mut self, rows: impl FnOnce() -> Spreadsheet) {
        if let Some(path) = &self.path
            && self.grow(path.clone(), rows()).is_none()
        {
            self.path = None;
        }
    }

    fn grow(&mut self, path: PathBuf, rows: Spreadsheet) -> Option<()> {
        let (mut file, rows) = match self.file.take() {
            Some(file) => (file, rows.without_head()),
            None => (File::create(path).ok()?, rows),
        };
        file.write_all(rows.text().ok()?.as_bytes()).ok()?;
        self.file = Some(file);
        Some(())
    }
}

fn store(
    folder: &Path,
    name: &str,
    document: &str,
    sheets: &[(&str, Spreadsheet)],
) -> Result<(), Failure> {
    for (sheet, content) in sheets {
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
    let mut growing = path.as_os_str().to_owned();
    growing.push(".part");
    let done = std::fs::write(&growing, text).and_then(|()| std::fs::rename(&growing, path));
    done.map_err(|error| {
        let _ = std::fs::remove_file(&growing);
        unwritten(path, &error)
    })
}

fn unwritten(path: &Path, error: &std::io::Error) -> Failure {
    Failure::failed(format!("cannot write {}: {error}", path.display()))
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
