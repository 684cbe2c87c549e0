//! Files that grow as results are found, and are whole after each addition.

use std::fs::File;
use std::io::{Result, Seek, SeekFrom, Write};
use std::path::PathBuf;

use super::interrupt::growing;
use super::spreadsheet::{Head, Row, csv, names};
use crate::report::whole;

/// A table that is there as far as it has come, whatever ends the program.
pub(super) struct Journal {
    path: Option<PathBuf>,
    head: Row,
    file: Option<Growing>,
}

impl Journal {
    /// A table with this head; nothing is kept without a path.
    pub(super) fn new(path: Option<PathBuf>, head: &[Head]) -> Self {
        Self {
            path,
            head: names(head),
            file: None,
        }
    }

    /// Adds rows; once that fails, no more: the whole is written at the end.
    pub(super) fn add(&mut self, rows: impl IntoIterator<Item = Row>) {
        if self.path.is_some() && self.grow(rows.into_iter()).is_none() {
            self.path = None;
        }
    }

    /// Begins anew with these rows.
    pub(super) fn replace(&mut self, rows: impl IntoIterator<Item = Row>) {
        if self.path.is_some() && self.rewrite(rows.into_iter()).is_none() {
            self.path = None;
        }
    }

    fn whole(&self, rows: impl Iterator<Item = Row>) -> Option<String> {
        csv(std::iter::once(self.head.clone()).chain(rows)).ok()
    }

    fn rewrite(&mut self, rows: impl Iterator<Item = Row>) -> Option<()> {
        let (path, text) = (self.path.clone()?, self.whole(rows)?);
        self.file = None;
        whole::write(&path, &text).ok()?;
        self.file = Some(Growing::carry_on(path, text.len() as u64).ok()?);
        Some(())
    }

    fn grow(&mut self, rows: impl Iterator<Item = Row>) -> Option<()> {
        if let Some(mut file) = self.file.take() {
            file.add(&csv(rows).ok()?).ok()?;
            self.file = Some(file);
        } else {
            let text = self.whole(rows)?;
            self.file = Some(Growing::begin(self.path.clone()?, &text).ok()?);
        }
        Some(())
    }
}

/// A file that is whole after each addition.
pub(super) struct Growing {
    path: PathBuf,
    file: File,
    length: u64,
}

impl Growing {
    /// A new file with this beginning, between which and nothing at all the program does not end.
    pub(super) fn begin(path: PathBuf, text: &str) -> Result<Self> {
        let mut files = growing();
        let mut new = Self::new(File::create(&path)?, path, 0, &mut files);
        new.write(text, &mut files)?;
        Ok(new)
    }

    /// A file that is there, of which only this many bytes are good.
    pub(super) fn carry_on(path: PathBuf, length: u64) -> Result<Self> {
        let mut file = File::options().write(true).open(&path)?;
        file.set_len(length)?;
        file.seek(SeekFrom::End(0))?;
        Ok(Self::new(file, path, length, &mut growing()))
    }

    fn new(file: File, path: PathBuf, length: u64, files: &mut Vec<PathBuf>) -> Self {
        if !files.contains(&path) {
            files.push(path.clone());
        }
        Self { path, file, length }
    }

    /// Adds whole lines, or nothing at all.
    pub(super) fn add(&mut self, text: &str) -> Result<()> {
        self.write(text, &mut growing())
    }

    fn write(&mut self, text: &str, files: &mut Vec<PathBuf>) -> Result<()> {
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
