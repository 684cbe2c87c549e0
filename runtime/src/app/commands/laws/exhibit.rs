//! A law ready to be shown, of whatever kind.

use serde_json::Value;

use super::curve::Curve;
use super::text::{describe, list};
use crate::app::spreadsheet::Spreadsheet;
use crate::friction::LawInfo;
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

/// What is drawn: a law, where it acts, and its curve.
pub(super) struct Drawn {
    pub(super) name: String,
    pub(super) law: &'static LawInfo,
    /// Where it acts, as declared.
    pub(super) place: Option<String>,
    /// Values of the law's parameters, where they are given and not computed.
    pub(super) values: Vec<f64>,
    pub(super) curve: Curve,
}

impl Drawn {
    /// Both lines of the law, as written.
    pub(super) fn formulas(&self) -> [String; 2] {
        let law = self.law;
        [
            format!("stick = {}", law.stick),
            format!("slip(s) = {}", law.slip),
        ]
    }

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
