//! A law ready to be shown, of whatever kind.

use serde_json::Value;

use super::Drawn;
use super::describe::{describe, list};
use crate::app::spreadsheet::Spreadsheet;
use crate::report::Figure;

/// A law as everything that the program writes.
pub(super) struct Exhibit {
    pub(super) name: String,
    /// A few lines, for a list.
    pub(super) listing: String,
    /// All that is known of it.
    pub(super) text: String,
    pub(super) document: Value,
    pub(super) figure: Figure,
    pub(super) sheet: Spreadsheet,
}

impl Drawn {
    pub(super) fn exhibit(&self) -> Exhibit {
        Exhibit {
            name: self.name.clone(),
            listing: list(self),
            text: describe(self),
            document: self.document(),
            figure: self.figure(),
            sheet: self.curve.sheet(),
        }
    }
}
