//! What a command has found, in all forms.

use serde::Serialize;
use serde_json::Value;

use super::document::value_of;
use super::spreadsheet::Spreadsheet;
use crate::report::Figure;

/// An answer in every form in which it may be wanted.
pub(super) struct Answer<'a> {
    /// Its name among files.
    pub(super) name: &'a str,
    pub(super) text: String,
    pub(super) document: Value,
    /// Tables by the names of their files.
    pub(super) sheets: Vec<(String, Spreadsheet)>,
    /// Pictures by the names of their files.
    pub(super) figures: Vec<(String, Figure)>,
}

impl<'a> Answer<'a> {
    /// An answer without tables and pictures.
    pub(super) fn new(name: &'a str, text: String, document: impl Serialize) -> Self {
        Self {
            name,
            text,
            document: value_of(document),
            sheets: Vec::new(),
            figures: Vec::new(),
        }
    }

    /// The same with one more table.
    pub(super) fn sheet(mut self, name: impl Into<String>, sheet: Spreadsheet) -> Self {
        self.sheets.push((name.into(), sheet));
        self
    }

    /// The same with one more picture.
    pub(super) fn figure(mut self, name: impl Into<String>, figure: Figure) -> Self {
        self.figures.push((name.into(), figure));
        self
    }

    /// The same with more words, and one more field of this name.
    pub(super) fn part(mut self, name: &str, text: &str, document: impl Serialize) -> Self {
        self.text.push_str(text);
        self.document[name] = value_of(document);
        self
    }
}
