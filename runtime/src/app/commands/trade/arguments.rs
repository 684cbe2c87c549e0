//! Arguments of `trade`.

use clap::Args;

use crate::app::arguments::{Period, Subject, Unresumable};
use crate::app::values::{Range, Reading};
use crate::study::trade::Scope;
use crate::study::{Case, Dynamics};

/// Measure what each smoothing gets wrong, and what it costs, against the exact system
#[derive(Debug, Clone, Args)]
#[group(skip)]
#[command(
    after_help = "--smooth restricts this to one copy; with --accuracy the cheapest settings that meet it are sought"
)]
pub(in crate::app) struct Arguments {
    #[command(flatten)]
    pub(super) subject: Subject,
    #[command(flatten)]
    pub(super) guess: Period,
    /// A parameter, to be judged at both A and B: the worst end counts
    #[arg(long, value_name = "NAME=A..B", value_parser = Reading(Range::read))]
    pub(super) along: Option<Range>,
    #[command(flatten)]
    pub(super) resume: Unresumable,
}

impl Arguments {
    /// What the trade covers.
    pub(super) fn scope(&self, case: &Case) -> Scope {
        let mut scope = Scope {
            accuracy: self.subject.accuracy,
            ..Scope::default()
        };
        if let Dynamics::Smoothed(smoothing) = case.dynamics {
            scope.kernels = vec![smoothing.kernel];
            scope.sign_sizes = vec![smoothing.size];
            scope.bump_sizes = vec![smoothing.size];
        }
        scope
    }
}
