//! `trade`: what smoothing costs, and what it gets wrong.

mod document;
mod sheet;
mod text;

use clap::Args;

use crate::app::answer::Answer;
use crate::app::arguments::{Period, Subject, Unresumable};
use crate::app::failure::{Failure, refuse};
use crate::app::interrupt;
use crate::app::offer::App;
use crate::app::progress::Progress;
use crate::app::request::request;
use crate::app::text::short;
use crate::app::values::{Range, Reading};
use crate::field::{Design, Kernel};
use crate::study::trade::{Finding, Scope};
use crate::study::{Case, Dynamics};

/// What is done all the time.
const MEASURING: &str = "measuring what smoothing costs";

/// Measure what each smoothing gets wrong, and what it costs, against the exact system
#[derive(Debug, Clone, Args)]
#[command(
    after_help = "--smooth restricts this to one copy; with --accuracy the cheapest settings that meet it are sought"
)]
pub(in crate::app) struct Arguments {
    #[command(flatten)]
    subject: Subject,
    #[command(flatten)]
    guess: Period,
    /// A parameter, to be judged at both A and B: the worst end counts
    #[arg(long, value_name = "NAME=A..B", value_parser = Reading(Range::read))]
    along: Option<Range>,
    #[command(flatten)]
    resume: Unresumable,
}

impl Arguments {
    /// What the trade covers.
    fn scope(&self, case: &Case) -> Scope {
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

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    arguments.resume.refuse()?;
    let range = arguments.along.as_ref();
    let asked = request(app, &arguments.subject, range, arguments.guess.period)?;
    let (info, case, output) = (asked.info, &asked.case, &asked.output);
    let scope = arguments.scope(case);
    if case.along.map(|along| along.design) == Some(Design::Smoothing) {
        return refuse!("`trade` goes through the sizes by itself: `--along` takes a parameter");
    }
    let progress = Progress::endless(output, MEASURING);
    let mut errors = output.journal("trade", sheet::copies(info, 0, Kernel::Arctan).head());
    let mut precisions = output.journal("work-precision", sheet::precision_head());
    let mut watch = |end: usize, finding: Finding<'_>| {
        match finding {
            Finding::Copy(kernel, point) => {
                progress.say(format!("{MEASURING}: {kernel}:{}", short(point.size)));
                errors.add([sheet::copies(info, end, kernel).row(point)])
            }
            Finding::Precision(one) => precisions.add(sheet::precision_rows(end, one)),
        }
        interrupt::verdict()
    };
    let record = asked.got(asked.entry.trade_watched(case, &scope, &mut watch))?;
    drop(progress);
    let answer = Answer::new(
        "trade",
        || text::describe(info, case, &record, scope.accuracy),
        || document::document(info, &record),
    )
    .sheet("trade", || sheet::errors(info, &record))
    .sheet("work-precision", || sheet::precisions(&record));
    output.deliver(&answer)?;
    if record.is_interrupted() {
        let curves = record.ends.iter().flat_map(|end| &end.trade.curves);
        let count: usize = curves.map(|curve| curve.points.len()).sum();
        return Err(output.interrupted(&format!("{count} copies were measured")));
    }
    Ok(())
}
