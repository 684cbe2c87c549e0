//! What a command has found, in every form in which it may be wanted; made where it is, and only there.

use serde::Serialize;
use serde_json::Value;

use super::document::{value_of, versioned};
use super::spreadsheet::Spreadsheet;
use crate::report::Figure;

/// Makes a form of an answer.
type Maker<'a, T> = Box<dyn Fn() -> T + 'a>;

/// An answer.
pub(super) struct Answer<'a> {
    /// Its name among files.
    pub(super) name: &'a str,
    text: Vec<Maker<'a, String>>,
    document: Maker<'a, Value>,
    parts: Vec<(&'a str, Maker<'a, Value>)>,
    /// Tables by the names of their files.
    pub(super) sheets: Vec<(String, Maker<'a, Spreadsheet>)>,
    /// Pictures by the names of their files.
    pub(super) figures: Vec<(String, Maker<'a, Figure>)>,
}

impl<'a> Answer<'a> {
    /// An answer without tables and pictures.
    pub(super) fn new<D: Serialize>(
        name: &'a str,
        text: impl Fn() -> String + 'a,
        document: impl Fn() -> D + 'a,
    ) -> Self {
        Self {
            name,
            text: vec![Box::new(text)],
            document: Box::new(move || value_of(document())),
            parts: Vec::new(),
            sheets: Vec::new(),
            figures: Vec::new(),
        }
    }

    /// The same with one more table.
    pub(super) fn sheet(
        mut self,
        name: impl Into<String>,
        sheet: impl Fn() -> Spreadsheet + 'a,
    ) -> Self {
        self.sheets.push((name.into(), Box::new(sheet)));
        self
    }

    /// The same with one more picture.
    pub(super) fn figure(
        mut self,
        name: impl Into<String>,
        figure: impl Fn() -> Figure + 'a,
    ) -> Self {
        self.figures.push((name.into(), Box::new(figure)));
        self
    }

    /// The same with more words.
    pub(super) fn words(mut self, text: impl Fn() -> String + 'a) -> Self {
        self.text.push(Box::new(text));
        self
    }

    /// The same with one more field of this name.
    pub(super) fn part<D: Serialize>(
        mut self,
        name: &'a str,
        document: impl Fn() -> D + 'a,
    ) -> Self {
        let part = move || value_of(document());
        self.parts.push((name, Box::new(part)));
        self
    }

    /// The names of its files.
    pub(super) fn files(&self) -> Vec<String> {
        let figures = self.figures.iter();
        let figures =
            figures.flat_map(|(name, _)| ["svg", "pdf"].map(|end| format!("{name}.{end}")));
        let columnar = cfg!(feature = "parquet").then_some("parquet");
        let sheets = self.sheets.iter().flat_map(|(name, _)| {
            let endings = std::iter::once("csv").chain(columnar);
            endings.map(move |end| format!("{name}.{end}"))
        });
        let document = format!("{}.json", self.name);
        figures.chain(sheets).chain([document]).collect()
    }

    /// All words.
    pub(super) fn text(&self) -> String {
        self.text.iter().map(|text| text()).collect()
    }

    /// The document with all its fields.
    pub(super) fn document(&self) -> Value {
        let mut document = versioned((self.document)());
        for (name, part) in &self.parts {
            document[*name] = part();
        }
        document
    }
}
