//! Where answers go: stdout and a folder.

use std::fmt::Display;
use std::fs::File;
use std::io::{ErrorKind, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use clap::ArgMatches;
use serde::Serialize;

use super::failure::Failure;
use super::interrupt::{growing, way_out};
use super::spreadsheet::Spreadsheet;
use crate::report::Figure;
use crate::report::whole;
use crate::study::Ended;

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
        print(if self.json { &document } else { &text }).and(written)
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
    pub(super) fn journal(&self, name: &str) -> Journal {
        Journal {
            path: self.path(&format!("{name}.csv")),
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
        if !self.quiet {
            let _ = writeln!(std::io::stderr(), "{note}");
        }
    }
}

/// A table that is there as far as it has come, whatever ends the program.
pub(super) struct Journal {
    path: Option<PathBuf>,
    file: Option<Growing>,
}

/// A file that is whole after each addition.
pub(super) struct Growing {
    path: PathBuf,
    file: File,
    length: u64,
}

impl Growing {
    /// A new file with this beginning.
    pub(super) fn begin(path: PathBuf, text: &str) -> std::io::Result<Self> {
        let file = File::create(&path)?;
        let mut new = Self::new(path, file, 0);
        new.add(text)?;
        Ok(new)
    }

    /// A file that is there, of which only this many bytes are good.
    pub(super) fn carry_on(path: PathBuf, length: u64) -> std::io::Result<Self> {
        let mut file = File::options().write(true).open(&path)?;
        file.set_len(length)?;
        file.seek(SeekFrom::End(0))?;
        Ok(Self::new(path, file, length))
    }

    fn new(path: PathBuf, file: File, length: u64) -> Self {
        growing().push(path.clone());
        Self { path, file, length }
    }

    /// Adds whole lines, or nothing at all.
    pub(super) fn add(&mut self, text: &str) -> std::io::Result<()> {
        let mut files = growing();
        let added = self.file.write_all(text.as_bytes());
        match &added {
            Ok(()) => self.length += text.len() as u64,
            Err(_) => {
                let _ = self.file.set_len(self.length);
                files.retain(|path| *path != self.path);
            }
        }
        added
    }
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
        let rows = match self.file {
            Some(_) => rows.without_head(),
            None => rows,
        };
        let rows = rows.text().ok()?;
        match self.file.take() {
            Some(mut file) => {
                file.add(&rows).ok()?;
                self.file = Some(file);
            }
            None => self.file = Some(Growing::begin(path, &rows).ok()?),
        }
        Some(())
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
