//! A report: sections of text, figures and tables, written as one page with its data beside it.

mod draw;
mod edition;
mod figure;
mod manuscript;
pub mod numerals;
mod page;
mod table;
mod text;
pub(crate) mod whole;

use std::io;
use std::path::{Path, PathBuf};

pub use edition::Edition;
pub use figure::{Axis, Curve, Figure, Marker, Panel, Shape};
pub use manuscript::Manuscript;
pub use table::{Column, Table};

/// A report.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Report {
    /// Its title.
    pub title: String,
    /// What it is about, in one sentence.
    pub subtitle: String,
    /// Its sections.
    pub sections: Vec<Section>,
}

/// A section.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Section {
    /// Its heading.
    pub title: String,
    /// What it holds, in reading order.
    pub blocks: Vec<Block>,
}

/// A part of a section.
#[derive(Debug, Clone, PartialEq)]
pub enum Block {
    /// A paragraph.
    Text(String),
    /// A formula on its own line.
    Formula(String),
    /// A figure drawn from data.
    Figure(Figure),
    /// A drawing that explains: an SVG element, and its caption.
    Sketch(&'static str, String),
    /// A table.
    Table(Table),
    /// A page of its own, to which this one leads.
    Page(Page),
}

/// A page of its own beside the report, with its data.
#[derive(Debug, Clone, PartialEq)]
pub struct Page {
    /// Its name as a file, without `.html`.
    pub name: String,
    /// What the link to it says.
    pub link: String,
    /// The whole page; it must need nothing but itself.
    pub html: String,
    /// Its data: the head, and the rows, of `data/<name>.csv`.
    pub data: (Vec<String>, Vec<Vec<String>>),
}

/// What was written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Written {
    /// The page.
    pub page: PathBuf,
    /// Figures drawn.
    pub figures: usize,
    /// Files of data.
    pub data: usize,
}

/// Why a report could not be written.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// A file or folder could not be written.
    #[error("cannot write {}: {source}", path.display())]
    Write {
        /// The file or folder.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A manuscript and what was given for its places do not fit.
    #[error("the section `{title}`: {faults}")]
    Manuscript {
        /// The heading of the section.
        title: String,
        /// What is missing or left over.
        faults: String,
    },
    /// A file of data could not be written.
    #[error("cannot write {}: {source}", path.display())]
    Data {
        /// The file.
        path: PathBuf,
        /// Why.
        source: csv::Error,
    },
}

impl Section {
    /// A section without content yet.
    #[must_use]
    pub fn new(title: &str) -> Self {
        Self {
            title: title.to_owned(),
            blocks: Vec::new(),
        }
    }

    /// The same section with one more paragraph.
    #[must_use]
    pub fn text(mut self, text: impl Into<String>) -> Self {
        self.blocks.push(Block::Text(text.into()));
        self
    }

    /// The same section with one more formula.
    #[must_use]
    pub fn formula(mut self, formula: impl Into<String>) -> Self {
        self.blocks.push(Block::Formula(formula.into()));
        self
    }

    /// The same section with one more figure.
    #[must_use]
    pub fn figure(mut self, figure: Figure) -> Self {
        self.blocks.push(Block::Figure(figure));
        self
    }

    /// The same section with one more sketch.
    #[must_use]
    pub fn sketch(mut self, svg: &'static str, caption: impl Into<String>) -> Self {
        self.blocks.push(Block::Sketch(svg, caption.into()));
        self
    }

    /// The same section with a link to one more page.
    #[must_use]
    pub fn page(mut self, page: Page) -> Self {
        self.blocks.push(Block::Page(page));
        self
    }

    /// The same section with one more table.
    #[must_use]
    pub fn table(mut self, table: Table) -> Self {
        self.blocks.push(Block::Table(table));
        self
    }
}

impl Report {
    /// Writes `index.html`, `figures/*.svg` and `data/*.csv` into the folder `out`.
    ///
    /// # Errors
    /// A file or folder cannot be written.
    pub fn write(self, out: &Path) -> Result<Written, ReportError> {
        let edition = Edition::begin(self, out)?;
        edition.save_page()?;
        Ok(edition.written())
    }
}
