//! Values of options, read while the command line is.

use std::ffi::OsStr;

use clap::builder::TypedValueParser;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, Command, Error};

use super::failure::{Failure, refuse};
use super::words::{both_sides, count, number, place, positive};
use crate::field::{Kernel, Smoothing, SmoothingError};

/// The name of what follows the size of a smoothing, where parameters have theirs.
pub(super) const SMOOTH: &str = "smooth";

/// Reads a value by a function that is told the option, for its messages, and the word.
#[derive(Clone)]
pub(super) struct Reading<T>(pub(super) fn(&str, &str) -> Result<T, Failure>);

impl<T: Clone + Send + Sync + 'static> TypedValueParser for Reading<T> {
    type Value = T;

    fn parse_ref(&self, _: &Command, arg: Option<&Arg>, word: &OsStr) -> Result<T, Error> {
        let option = arg.and_then(Arg::get_long).unwrap_or_default();
        let word = word
            .to_str()
            .ok_or_else(|| Error::new(ErrorKind::InvalidUtf8))?;
        (self.0)(&format!("--{option}"), word).map_err(|failure| {
            let mut error = Error::new(ErrorKind::ValueValidation);
            let message = ContextValue::String(failure.to_string());
            error.insert(ContextKind::Custom, message);
            error
        })
    }
}

/// `name=value`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Assignment {
    pub(super) word: String,
    pub(super) name: String,
    pub(super) value: f64,
}

impl Assignment {
    pub(super) fn read(option: &str, word: &str) -> Result<Self, Failure> {
        let (name, value) = both_sides(option, word)?;
        if value.contains('=') {
            return refuse!(
                "`{option} {word}` assigns more than once: write `{option}` before each"
            );
        }
        Ok(Self {
            word: word.to_owned(),
            name: name.to_owned(),
            value: number(&format!("{option} {word}"), value)?,
        })
    }
}

/// `name=a..b`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Range {
    pub(super) word: String,
    pub(super) name: String,
    pub(super) from: f64,
    pub(super) to: f64,
}

impl Range {
    pub(super) fn read(option: &str, word: &str) -> Result<Self, Failure> {
        let place = format!("{option} {word}");
        let (name, range) = both_sides(option, word)?;
        let ends = range
            .split_once("..")
            .filter(|(_, to)| !to.starts_with('.'));
        let Some((from, to)) = ends else {
            return refuse!(
                "`{place}`: `{range}` is no range: write where it begins and ends, for instance `{name}=0.2..0.1`"
            );
        };
        let end: fn(&str, &str) -> Result<f64, Failure> =
            if name == SMOOTH { positive } else { number };
        let (from, to) = (end(&place, from)?, end(&place, to)?);
        if from == to {
            return refuse!(
                "`{place}` begins and ends at {from}: there is nothing to follow; `orbit` finds a single orbit"
            );
        }
        let (word, name) = (word.to_owned(), name.to_owned());
        Ok(Self {
            word,
            name,
            from,
            to,
        })
    }
}

/// `kernel:size`, or `kernel` alone, which is enough where its size is followed.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SmoothCopy {
    pub(super) word: String,
    pub(super) kernel: Kernel,
    pub(super) smoothing: Result<Smoothing, SmoothingError>,
}

impl SmoothCopy {
    pub(super) fn read(option: &str, word: &str) -> Result<Self, Failure> {
        let smoothing = word.parse::<Smoothing>();
        let kernel = match &smoothing {
            Ok(smoothing) => smoothing.kernel,
            Err(SmoothingError::BadSize { kernel, .. }) if !word.contains(':') => *kernel,
            Err(error) => return refuse!("`{option} {word}`: {error}"),
        };
        Ok(Self {
            word: word.to_owned(),
            kernel,
            smoothing,
        })
    }

    /// With its size.
    ///
    /// # Errors
    /// It has none.
    pub(super) fn sized(&self) -> Result<Smoothing, Failure> {
        let refused = |error| Failure::usage(format!("`--smooth {}`: {error}", self.word));
        self.smoothing.clone().map_err(refused)
    }
}

/// A relative accuracy that numbers can meet.
pub(super) fn accuracy(option: &str, word: &str) -> Result<f64, Failure> {
    let value = number(option, word)?;
    if value > 1e-13 && value < 1e-1 {
        return Ok(value);
    }
    refuse!("`{option} {word}` is out of reach: a relative accuracy lies between 1e-13 and 1e-1")
}

/// Reads a whole number between `LEAST` and `MOST`.
pub(super) const fn counted<const LEAST: usize, const MOST: usize>() -> Reading<usize> {
    Reading(|option, word| count(option, word, [LEAST, MOST]))
}

/// The one of `all` that `word` names; `what` says what it would be, if there is none.
pub(super) fn one_of<T: Copy, const COUNT: usize>(
    all: [T; COUNT],
    name: fn(T) -> &'static str,
    what: &str,
    word: &str,
) -> Result<T, Failure> {
    Ok(all[place(what, word, &all.map(name))?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_assignment_has_its_option() {
        let told = Assignment::read("--set", "a=1,b=2").map_err(|failure| failure.to_string());
        assert!(told.is_err_and(|words| words.contains("`--set` before each")));
        assert_eq!(
            Assignment::read("--set", "a=1").map(|one| one.value),
            Ok(1.0)
        );
    }
}
