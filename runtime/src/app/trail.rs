//! What is found on a way: written row by row, and shown as progress.

use std::ops::ControlFlow;

use super::journal::Journal;
use super::progress::Progress;
use super::request::Request;
use super::spreadsheet::Row;
use super::text::number;
use crate::model::ModelInfo;
use crate::study::Along;

/// The findings along a design variable.
pub(super) struct Trail<'a> {
    info: &'a ModelInfo,
    along: Along,
    journal: Journal,
    progress: &'a Progress,
}

impl<'a> Trail<'a> {
    /// Nothing is found yet; the table of this name will have this head.
    pub(super) fn new(
        asked: &Request<'_>,
        along: Along,
        name: &str,
        head: Row,
        progress: &'a Progress,
    ) -> Self {
        Self {
            info: asked.info,
            along,
            journal: asked.output.journal(name, head),
            progress,
        }
    }

    /// A finding at the user's value `value`; the answer says whether to go on.
    pub(super) fn reach(&mut self, value: f64, row: Row) -> ControlFlow<()> {
        self.journal.add([row]);
        let message = format!("{} = {}", self.along.name(self.info), number(value, 6));
        self.progress.reach(self.along.share(value), message)
    }
}
