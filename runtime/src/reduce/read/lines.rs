//! The lines of a file, and what to say of a wrong one.

use crate::reduce::error::ReduceError;

/// The lines of a file.
pub(super) struct Lines<'a> {
    file: &'a str,
    text: &'a str,
}

/// A line with its number.
#[derive(Clone, Copy)]
pub(super) struct Line<'a> {
    file: &'a str,
    number: usize,
    pub(super) text: &'a str,
}

impl<'a> Lines<'a> {
    pub(super) fn of(file: &'a str, text: &'a str) -> Self {
        Self { file, text }
    }

    /// All lines that are not blank.
    pub(super) fn all(&self) -> impl Iterator<Item = Line<'a>> + use<'a> {
        let file = self.file;
        let lines = self.text.lines().enumerate();
        lines
            .map(move |(index, text)| Line {
                file,
                number: index + 1,
                text,
            })
            .filter(|line| !line.text.trim().is_empty())
    }

    /// What the file as a whole lacks.
    pub(super) fn lacks(&self, reason: impl Into<String>) -> ReduceError {
        ReduceError::Malformed {
            file: self.file.to_owned(),
            line: self.text.lines().count(),
            reason: reason.into(),
        }
    }
}

impl Line<'_> {
    pub(super) fn wrong(&self, reason: impl Into<String>) -> ReduceError {
        ReduceError::Malformed {
            file: self.file.to_owned(),
            line: self.number,
            reason: reason.into(),
        }
    }

    /// A whole number.
    pub(super) fn index(&self, word: &str) -> Result<u32, ReduceError> {
        let word = word.trim();
        word.parse()
            .map_err(|_| self.wrong(format!("`{word}` is no row or column")))
    }

    /// A row or column from 1 up to `most`, counted from 0.
    pub(super) fn row(&self, word: &str, most: usize) -> Result<u32, ReduceError> {
        let index = self.index(word)?;
        if index == 0 || index as usize > most {
            return Err(self.wrong(format!("row or column {index} lies outside 1 to {most}")));
        }
        Ok(index - 1)
    }

    /// A finite value; Fortran's `D` is an exponent, too.
    pub(super) fn value(&self, word: &str) -> Result<f64, ReduceError> {
        let word = word.trim();
        let plain = word.parse::<f64>();
        let parsed = plain.or_else(|_| word.replace(['D', 'd'], "e").parse());
        match parsed {
            Ok(value) if value.is_finite() && value.abs() < 1e100 => Ok(value),
            Ok(_) => Err(self.wrong(format!("`{word}` is not finite, or out of reach (1e100)"))),
            Err(_) => Err(self.wrong(format!("`{word}` is not a number"))),
        }
    }
}
