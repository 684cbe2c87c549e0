//! Tables, as CSV and on the terminal.

use nalgebra::Complex;

use super::failure::Failure;
use super::text::{line, table};
use crate::report::whole;

/// A line of a table.
pub(super) type Row = Vec<String>;

/// A table of words and numbers, its head first.
pub(super) type Spreadsheet = Vec<Row>;

/// A table with this head.
pub(super) fn headed(head: Row, rows: impl IntoIterator<Item = Row>) -> Spreadsheet {
    std::iter::once(head).chain(rows).collect()
}

/// Rows as CSV.
pub(super) fn csv<R>(rows: impl IntoIterator<Item = R>) -> Result<String, Failure>
where
    R: IntoIterator<Item: AsRef<[u8]>>,
{
    whole::csv(rows)
        .map_err(|error| Failure::failed(format!("the table cannot be written: {error}")))
}

/// A table described once: the head of each column, and what stands under it for a finding.
pub(super) struct Columns<'a, T>(Vec<(String, Cell<'a, T>)>);

type Cell<'a, T> = Box<dyn Fn(&T) -> String + 'a>;

impl<'a, T: 'a> Columns<'a, T> {
    pub(super) const fn new() -> Self {
        Self(Vec::new())
    }

    /// One more column.
    pub(super) fn column<S: Into<String>>(
        mut self,
        head: impl Into<String>,
        cell: impl Fn(&T) -> S + 'a,
    ) -> Self {
        let cell = move |finding: &T| cell(finding).into();
        self.0.push((head.into(), Box::new(cell)));
        self
    }

    /// One more column of numbers with all their digits, empty where there is none.
    pub(super) fn number<V: Into<Option<f64>>>(
        self,
        head: impl Into<String>,
        value: impl Fn(&T) -> V + 'a,
    ) -> Self {
        self.column(head, move |finding| optional(value(finding).into()))
    }

    /// One more column for each head, which `cell` is told the number of.
    pub(super) fn each(
        self,
        heads: impl IntoIterator<Item = String>,
        cell: impl Fn(&T, usize) -> String + Copy + 'a,
    ) -> Self {
        let heads = heads.into_iter().enumerate();
        heads.fold(self, |columns, (j, head)| {
            columns.column(head, move |finding| cell(finding, j))
        })
    }

    /// The same with numbers, empty where there is none.
    pub(super) fn numbers(
        self,
        heads: impl IntoIterator<Item = String>,
        value: impl Fn(&T, usize) -> Option<f64> + Copy + 'a,
    ) -> Self {
        self.each(heads, move |finding, j| optional(value(finding, j)))
    }

    pub(super) fn head(&self) -> Row {
        self.0.iter().map(|(head, _)| head.clone()).collect()
    }

    pub(super) fn row(&self, finding: &T) -> Row {
        self.0.iter().map(|(_, cell)| cell(finding)).collect()
    }

    /// The table of these findings as a file.
    pub(super) fn sheet<'b>(&self, findings: impl IntoIterator<Item = &'b T>) -> Spreadsheet
    where
        T: 'b,
    {
        let rows = findings.into_iter().map(|finding| self.row(finding));
        headed(self.head(), rows)
    }

    /// The table of these findings on the terminal.
    pub(super) fn text<'b>(&self, findings: impl IntoIterator<Item = &'b T>) -> String
    where
        T: 'b,
    {
        table(
            &self
                .sheet(findings)
                .into_iter()
                .map(line)
                .collect::<String>(),
        )
    }
}

/// The heads of columns for the parts of values number 1 to `count`: `multiplier_1_re`, ...
pub(super) fn parts(name: &str, count: usize, parts: &[&str]) -> Vec<String> {
    let of = |i| parts.iter().map(move |part| format!("{name}_{i}_{part}"));
    (1..=count).flat_map(of).collect()
}

/// The real part of a value for an even number, its imaginary part for the odd one after.
pub(super) fn part(values: &[Complex<f64>], number: usize) -> Option<f64> {
    let value = values.get(number / 2)?;
    Some([value.re, value.im][number % 2])
}

/// All digits of a number, or nothing.
pub(super) fn optional(value: Option<f64>) -> String {
    value.as_ref().map(full).unwrap_or_default()
}

/// All digits of a number.
pub(super) fn full(value: &f64) -> String {
    format!("{value:?}")
}
