//! Progress on a terminal.

use std::io::IsTerminal;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

use super::output::Output;

/// Parts into which the way of a branch is divided.
const PARTS: u64 = 1000;

/// A sign of life on stderr, gone when it is dropped; nothing where nobody would see it.
pub(super) struct Progress(ProgressBar);

impl Progress {
    /// Work of unknown length.
    pub(super) fn endless(output: &Output, message: &'static str) -> Self {
        Self::visible(output).map_or_else(Self::hidden, |()| {
            let bar = ProgressBar::new_spinner().with_message(message);
            bar.enable_steady_tick(Duration::from_millis(100));
            Self(bar)
        })
    }

    /// Work along a way, see [`Progress::reach`].
    pub(super) fn along(output: &Output) -> Self {
        Self::visible(output).map_or_else(Self::hidden, |()| {
            let bar = ProgressBar::new(PARTS).with_message("looking for the first orbit");
            let style = ProgressStyle::with_template("{bar:40} {percent:>3} %  {msg}");
            Self(style.map_or_else(|_| bar.clone(), |style| bar.clone().with_style(style)))
        })
    }

    /// The share of the way done, and what is there.
    pub(super) fn reach(&self, share: f64, message: String) {
        self.0.set_position((share * PARTS as f64) as u64);
        self.0.set_message(message);
    }

    fn visible(output: &Output) -> Option<()> {
        (!output.quiet && std::io::stderr().is_terminal()).then_some(())
    }

    fn hidden() -> Self {
        Self(ProgressBar::hidden())
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
