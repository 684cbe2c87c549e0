//! A report: sections of text, figures and tables, written as one page with its data beside it.

pub mod chart;
mod curve;
mod data;
mod draw;
mod figure;
mod manuscript;
pub mod numerals;
mod page;
mod pdf;
mod special;
mod symbol;
pub mod symbols;
mod text;
mod traced;
pub(crate) mod whole;
mod written;

use std::io;
use std::path::PathBuf;

pub use curve::{COLOURS, Curve, Marker, SHADES, Shape};
pub use figure::{Axis, Figure, Inset, Panel};
pub use manuscript::Manuscript;
pub use traced::{Coordinate, traced};
pub use written::{Report, Written};

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

/// A table with a caption.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Its name in files and links: lower case, words joined by hyphens.
    pub name: String,
    /// What it shows.
    pub caption: String,
    /// Its columns.
    pub columns: Vec<Column>,
    /// Its rows, one cell for each column.
    pub rows: Vec<Vec<String>>,
    /// Whether it is long, and unfolds on request; it is not printed then.
    pub folded: bool,
}

/// A column of a table.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Its head.
    pub head: String,
    /// Whether its cells are numbers, and set flush right.
    pub numeric: bool,
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
}
