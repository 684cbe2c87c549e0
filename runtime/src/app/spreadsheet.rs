//! CSV files.

use super::failure::Failure;
use super::text::label;
use crate::model::Unit;

/// A line of a table.
pub(super) type Row = Vec<String>;

/// A table of words and numbers with a head.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Spreadsheet {
    rows: Vec<Row>,
}

impl Spreadsheet {
    /// A table with this head.
    pub(super) fn new(head: Row, rows: impl IntoIterator<Item = Row>) -> Self {
        Self {
            rows: std::iter::once(head).chain(rows).collect(),
        }
    }

    /// The table as CSV.
    pub(super) fn text(&self) -> Result<String, Failure> {
        csv(&self.rows)
    }
}

/// Rows as CSV.
pub(super) fn csv<R>(rows: impl IntoIterator<Item = R>) -> Result<String, Failure>
where
    R: IntoIterator<Item: AsRef<[u8]>>,
{
    let failed = |error: &dyn std::fmt::Display| {
        Failure::failed(format!("the table cannot be written: {error}"))
    };
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.write_record(row).map_err(|error| failed(&error))?;
    }
    let bytes = writer.into_inner().map_err(|error| failed(&error))?;
    String::from_utf8(bytes).map_err(|error| failed(&error))
}

/// The head of a table: words, and what they are followed by.
pub(super) fn head<const COUNT: usize>(words: [&str; COUNT]) -> Row {
    words.map(str::to_owned).to_vec()
}

/// The heads of columns with their units.
pub(super) fn labels(
    named: impl Iterator<Item = (&'static str, Option<Unit>)>,
) -> impl Iterator<Item = String> {
    named.map(|(name, unit)| label(name, unit))
}

/// All digits of a number, or nothing.
pub(super) fn optional(value: Option<f64>) -> String {
    value.as_ref().map(full).unwrap_or_default()
}

/// All digits of a number.
pub(super) fn full(value: &f64) -> String {
    format!("{value:?}")
}
