//! A range with the number of its values.

use crate::app::failure::Failure;
use crate::app::values::Range;
use crate::app::words::count;

/// Values where nothing is said.
const USUAL: usize = 50;

/// `name=a..b:n`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Spaced {
    pub(super) range: Range,
    pub(super) count: usize,
}

impl Spaced {
    pub(super) fn read(option: &str, word: &str) -> Result<Self, Failure> {
        let (range, number) = match word.rsplit_once(':') {
            Some((range, number)) => (
                range,
                count(&format!("{option} {word}:"), number, [2, 1_000_000])?,
            ),
            None => (word, USUAL),
        };
        Ok(Self {
            range: Range::read(option, range)?,
            count: number,
        })
    }
}
