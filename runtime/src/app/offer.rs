//! What a program offers: models, laws, and the report.

use std::error::Error;
use std::path::Path;

use super::failure::Failure;
use super::words;
use crate::study::{Shown, System};

/// Writes a report to a folder; quietly if the flag says so.
pub type Reproduction = fn(folder: &Path, quiet: bool) -> Result<(), Box<dyn Error>>;

/// A program that studies models from the command line.
pub struct App {
    pub(super) version: &'static str,
    pub(super) entries: Vec<System>,
    pub(super) laws: Vec<Shown>,
    pub(super) reproduction: Option<Reproduction>,
    pub(super) parts: Vec<(&'static str, Reproduction)>,
}

impl App {
    /// A program of this version, still without models.
    #[must_use]
    pub fn new(version: &'static str) -> Self {
        Self {
            version,
            entries: Vec::new(),
            laws: Vec::new(),
            reproduction: None,
            parts: Vec::new(),
        }
    }

    /// Offers one more model.
    #[must_use]
    pub fn offer(mut self, entry: System) -> Self {
        self.entries.push(entry);
        self
    }

    /// Lists more friction laws.
    #[must_use]
    pub fn laws<L: Into<Shown>>(mut self, laws: impl IntoIterator<Item = L>) -> Self {
        self.laws.extend(laws.into_iter().map(Into::into));
        self
    }

    /// Adds the command `reproduce`, which is also what happens without a command.
    #[must_use]
    pub fn reproduce(mut self, reproduction: Reproduction) -> Self {
        self.reproduction = Some(reproduction);
        self
    }

    /// Lets `reproduce` make one part of all alone, by this name.
    #[must_use]
    pub fn reproduce_part(mut self, name: &'static str, reproduction: Reproduction) -> Self {
        self.parts.push((name, reproduction));
        self
    }

    /// The model of this name on the command line.
    pub(super) fn entry(&self, name: &str) -> Result<&System, Failure> {
        let place = words::place("there is no model", name, &self.names())?;
        Ok(&self.entries[place])
    }

    pub(super) fn names(&self) -> Vec<&'static str> {
        self.entries
            .iter()
            .map(|entry| entry.info().command)
            .collect()
    }
}
