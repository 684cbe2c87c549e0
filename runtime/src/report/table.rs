//! A table as data.

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
}

/// A column of a table.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Its head.
    pub head: String,
    /// Whether its cells are numbers, and set flush right.
    pub numeric: bool,
}
