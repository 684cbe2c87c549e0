//! `trade`: what smoothing costs, and what it gets wrong.

mod document;
mod sheet;
mod text;

use std::sync::{Mutex, PoisonError};

use clap::Args;

use crate::app::answer::Answer;
use crate::app::arguments::{Period, Subject};
use crate::app::failure::{Failure, refuse};
use crate::app::journal::Journal;
use crate::app::ledger::{Ledger, Sharing};
use crate::app::offer::App;
use crate::app::question::Question;
use crate::app::request::request;
use crate::app::values::{Range, Reading};
use crate::field::{Design, Kernel};
use crate::model::ModelInfo;
use crate::study::trade::{Part, Scope};
use crate::study::{Case, Dynamics, Item};

/// What is done all the time.
const MEASURING: &str = "measuring what smoothing costs";

/// Measure what each smoothing gets wrong, and what it costs, against the exact system
#[derive(Debug, Clone, Args)]
#[command(
    after_help = "--smooth restricts this to one copy; with --accuracy the cheapest settings that meet it are sought. Times \
                  are measured, and differ from run to run: all else depends neither on threads nor on shares",
    mut_arg("threads", |arg| arg.help("How many threads; one if nothing is said, so that times are measured undisturbed"))
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
    sharing: Sharing,
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
    let range = arguments.along.as_ref();
    let asked = request(app, &arguments.subject, range, arguments.guess.period)?;
    let (info, case, output) = (asked.info, &asked.case, &asked.output);
    let scope = arguments.scope(case);
    if case.along.map(|along| along.design) == Some(Design::Smoothing) {
        return refuse!("`trade` goes through the sizes by itself: `--along` takes a parameter");
    }
    let question = Question::new(app.version, info, case).exactly("`--accuracy`", &scope);
    let sharing = arguments.sharing.on_one_thread();
    let ledger: Ledger<Part> = Ledger::open(&asked, &sharing, "trade", question, scope.rows(case))?;
    let papers = Mutex::new(Papers {
        info,
        errors: ledger.journal(
            output,
            "trade",
            &sheet::copies(info, 0, Kernel::Arctan).head(),
        ),
        precisions: ledger.journal(output, "work-precision", &sheet::precision_head()),
    });
    let found = |item: &Item<'_, Part>| {
        let mut papers = papers.lock().unwrap_or_else(PoisonError::into_inner);
        papers.take(scope.end_of(item.number), item.found)
    };
    let record = ledger.answer(&asked, MEASURING, &found, |list, watch| {
        asked.entry.trade_watched(case, &scope, list, watch)
    })?;
    if !ledger.is_shared() {
        let answer = Answer::new(
            "trade",
            || text::describe(info, case, &record, scope.accuracy),
            || document::document(info, &record),
        );
        let answer = answer
            .sheet("trade", || sheet::errors(info, &record))
            .sheet("work-precision", || sheet::precisions(&record));
        output.deliver(&answer)?;
    }
    ledger.close(output, record.missing)
}

/// What is written of each item as it is found.
struct Papers {
    info: &'static ModelInfo,
    errors: Journal,
    precisions: Journal,
}

impl Papers {
    /// Writes an item, and says what is done.
    fn take(&mut self, end: usize, part: &Part) -> String {
        let precision = match part {
            Part::Exact(exact) => &exact.precision,
            Part::Copy(copied) => {
                let columns = sheet::copies(self.info, end, copied.smoothing.kernel);
                self.errors.add([columns.row(&copied.point)]);
                &copied.precision
            }
            Part::Lost(_) | Part::Need(_) | Part::Refused(_) => return MEASURING.to_owned(),
        };
        self.precisions.add(sheet::precision_rows(end, precision));
        format!("{MEASURING}: {}", precision.dynamics())
    }
}
