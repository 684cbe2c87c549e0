//! Progress on a terminal, and what is found on the way.

use std::io::IsTerminal;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Duration;

use super::interrupt::{self, Work};
use super::journal::Journal;
use super::output::Output;
use super::request::Request;
use super::spreadsheet::Columns;
use super::text::number;
use crate::model::ModelInfo;
use crate::study::{Along, News};
use indicatif::{ProgressBar, ProgressStyle};

/// Parts into which the way of a branch is divided.
const PARTS: u64 = 1000;

/// A long computation: a sign of life on stderr, where somebody would see it, until it is dropped or interrupted.
pub(super) struct Progress {
    bar: ProgressBar,
    _work: Work,
}

impl Progress {
    /// Work of unknown length.
    pub(super) fn endless(output: &Output, message: &'static str) -> Self {
        Self::shown(output, || {
            let bar = ProgressBar::new_spinner().with_message(message);
            bar.enable_steady_tick(Duration::from_millis(100));
            bar
        })
    }

    /// Work along a way, see [`Progress::reach`].
    pub(super) fn along(output: &Output, message: &'static str) -> Self {
        Self::shown(output, || {
            let bar = ProgressBar::new(PARTS).with_message(message);
            let style = ProgressStyle::with_template("{bar:40} {percent:>3} %  {msg}");
            style.map_or_else(|_| bar.clone(), |style| bar.clone().with_style(style))
        })
    }

    /// The share of the way done, and what is there; the answer says whether to go on.
    pub(super) fn reach(&self, share: f64, message: String) -> ControlFlow<()> {
        self.bar.set_position((share * PARTS as f64) as u64);
        self.bar.set_message(message);
        interrupt::verdict()
    }

    /// Says on what it is working now.
    pub(super) fn say(&self, message: String) {
        self.bar.set_message(message);
    }

    /// Shows on what a search is working, after this message.
    pub(super) fn news(&self, message: &'static str) -> News {
        let bar = self.bar.clone();
        Arc::new(move |words| bar.set_message(format!("{message}: {words}")))
    }

    fn shown(output: &Output, bar: impl FnOnce() -> ProgressBar) -> Self {
        let visible = !output.is_quiet() && std::io::stderr().is_terminal();
        Self {
            bar: if visible {
                bar()
            } else {
                ProgressBar::hidden()
            },
            _work: Work::begin(output.last_words()),
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

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
            journal: asked.output.journal(name, &columns.head()),
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
