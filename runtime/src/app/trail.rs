//! What is found on a way: written row by row, and shown as progress.

use std::ops::ControlFlow;

use super::journal::Journal;
use super::progress::Progress;
use super::request::Request;
use super::spreadsheet::Columns;
use super::text::number;
use crate::model::ModelInfo;
use crate::study::Along;

/// The findings along a design variable.
pub(super) struct Trail<'a, T> {
    info: &'a ModelInfo,
    along: Along,
    columns: Columns<'static, T>,
    journal: Journal,
    progress: &'a Progress,
}

impl<'a, T: 'static> Trail<'a, T> {
    /// Nothing is found yet; the table of this name will have these columns.
    pub(super) fn new(
        asked: &Request<'_>,
        along: Along,
        name: &str,
        columns: Columns<'static, T>,
        progress: &'a Progress,
    ) -> Self {
        Self {
            info: asked.info,
            along,
            journal: asked.output.journal(name, columns.head()),
            columns,
            progress,
        }
    }

    /// A finding at the user's value `value`; the answer says whether to go on.
    pub(super) fn reach(&mut self, value: Option<f64>, finding: &T) -> ControlFlow<()> {
        let Some(value) = value else {
            return ControlFlow::Continue(());
        };
        self.journal.add([self.columns.row(finding)]);
        let message = format!("{} = {}", self.along.name(self.info), number(value, 6));
        self.progress.reach(self.along.share(value), message)
    }
}
