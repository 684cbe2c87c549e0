//! Tables, as CSV and on the terminal.

use std::fmt::Display;

use nalgebra::Complex;

use super::failure::Failure;
use super::text::{line, table};
use crate::report::whole;

/// A line of a table.
pub(super) type Row = Vec<String>;

/// The head of a column.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Head {
    /// Its name, with its unit in parentheses.
    pub(super) name: String,
    /// What stands under it, where its cells are not empty.
    pub(super) holds: Holds,
}

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Holds {
    /// Words.
    Words,
    /// Numbers with all their digits.
    Numbers,
    /// Whole numbers.
    Counts,
    /// `true` and `false`.
    Truths,
}

impl Holds {
    /// The head of a column of this name that holds them.
    pub(super) fn under(self, name: impl Into<String>) -> Head {
        Head {
            name: name.into(),
            holds: self,
        }
    }
}

/// A table of words and numbers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Spreadsheet {
    pub(super) head: Vec<Head>,
    pub(super) rows: Vec<Row>,
}

impl Spreadsheet {
    /// All lines, that of the names first.
    pub(super) fn lines(&self) -> impl Iterator<Item = Row> + '_ {
        std::iter::once(names(&self.head)).chain(self.rows.iter().cloned())
    }
}

/// A table with this head.
pub(super) fn headed(head: Vec<Head>, rows: impl IntoIterator<Item = Row>) -> Spreadsheet {
    let rows = rows.into_iter().collect();
    Spreadsheet { head, rows }
}

/// The names in a head.
pub(super) fn names(head: &[Head]) -> Row {
    head.iter().map(|head| head.name.clone()).collect()
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
pub(super) struct Columns<'a, T>(Vec<(Head, Cell<'a, T>)>);

type Cell<'a, T> = Box<dyn Fn(&T) -> String + 'a>;

impl<'a, T: 'a> Columns<'a, T> {
    pub(super) const fn new() -> Self {
        Self(Vec::new())
    }

    /// One more column.
    fn of(mut self, head: Head, cell: impl Fn(&T) -> String + 'a) -> Self {
        self.0.push((head, Box::new(cell)));
        self
    }

    /// One more column of words.
    pub(super) fn column<S: Into<String>>(
        self,
        head: impl Into<String>,
        cell: impl Fn(&T) -> S + 'a,
    ) -> Self {
        self.of(Holds::Words.under(head), move |finding| {
            cell(finding).into()
        })
    }

    /// One more column of numbers with all their digits, empty where there is none.
    pub(super) fn number<V: Into<Option<f64>>>(
        self,
        head: impl Into<String>,
        value: impl Fn(&T) -> V + 'a,
    ) -> Self {
        self.of(Holds::Numbers.under(head), move |finding| {
            optional(value(finding).into())
        })
    }

    /// One more column of whole numbers.
    pub(super) fn count<C: Display>(
        self,
        head: impl Into<String>,
        count: impl Fn(&T) -> C + 'a,
    ) -> Self {
        self.of(Holds::Counts.under(head), move |finding| {
            count(finding).to_string()
        })
    }

    /// One more column of what is true or false.
    pub(super) fn truth(self, head: impl Into<String>, truth: impl Fn(&T) -> bool + 'a) -> Self {
        self.of(Holds::Truths.under(head), move |finding| {
            truth(finding).to_string()
        })
    }

    /// One more column of words for each head, which `cell` is told the number of.
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
        let heads = heads.into_iter().enumerate();
        heads.fold(self, |columns, (j, head)| {
            columns.number(head, move |finding| value(finding, j))
        })
    }

    pub(super) fn head(&self) -> Vec<Head> {
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
        table(&self.sheet(findings).lines().map(line).collect::<String>())
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
