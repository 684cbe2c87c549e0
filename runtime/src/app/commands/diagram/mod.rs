//! `diagram`: where motions meet a section, for many values of a design variable.

mod answer;

use std::sync::{Mutex, PoisonError};

use clap::Args;

use crate::app::arguments::{Subject, Way};
use crate::app::failure::{Failure, refuse};
use crate::app::journal::Journal;
use crate::app::ledger::{Ledger, Sharing};
use crate::app::offer::App;
use crate::app::question::Question;
use crate::app::request::{Request, request};
use crate::app::section::Cut;
use crate::app::show::Show;
use crate::app::text::number;
use crate::app::values::{Reading, counted, one_of};
use crate::model::ModelInfo;
use crate::poincare::{Section, Surface};
use crate::study::{Along, Case, Diagram, DiagramRecord, Item, Motion, Slice, Sweep};

/// Draw a Poincaré diagram: let the motion settle at many values of a parameter, and note where it meets a section
#[derive(Debug, Clone, Args)]
#[command(
    after_help = "A sweep begins each value where the one before ended, and so stays with its attractor; `--sweep fresh` \
                  begins each at the start. Nothing depends on threads or shares: of sweeps, each is one share of the work \
                  at most, of fresh starts each value. A model with a drive is looked at once in each turn of it, \
                  unless `--section` says otherwise; its period-n counts turns of the drive. Where the first state only runs on, \
                  as the angle of a shaft, the section is made by the first that turns"
)]
pub(in crate::app) struct Arguments {
    #[command(flatten)]
    subject: Subject,
    #[command(flatten)]
    way: Way,
    #[command(flatten)]
    cut: Cut,
    /// `up`, `down`, `both` or `fresh`
    #[arg(long, value_name = "WAY", default_value = "both", value_parser = Reading(sweep))]
    sweep: Sweep,
    /// How many values of the parameter
    #[arg(long, value_name = "N", default_value = "200", value_parser = counted::<2, 1_000_000>())]
    values: usize,
    /// Points left out while the motion settles
    #[arg(long, value_name = "N", default_value = "300", value_parser = counted::<0, 100_000_000>())]
    settle: usize,
    /// Points noted at each value
    #[arg(long, value_name = "N", default_value = "64", value_parser = counted::<1, 10_000_000>())]
    points: usize,
    /// The largest Lyapunov exponent too, averaged over N laps
    #[arg(long, value_name = "N", value_parser = counted::<2, 100_000_000>())]
    lyapunov: Option<usize>,
    #[command(flatten)]
    show: Show,
    #[command(flatten)]
    sharing: Sharing,
}

fn sweep(option: &str, word: &str) -> Result<Sweep, Failure> {
    one_of(
        Sweep::ALL,
        Sweep::name,
        &format!("`{option}` knows no way"),
        word,
    )
}

impl Arguments {
    /// What is to be drawn.
    fn diagram(&self, asked: &Request<'_>) -> Result<Diagram, Failure> {
        let section = match self.cut.of(asked.info)? {
            Some(section) => section,
            None => asked.got(asked.entry.section(&asked.case))?,
        };
        Ok(Diagram {
            section,
            sweep: self.sweep,
            values: self.values,
            settle: self.settle,
            points: self.points,
            lyapunov: self.lyapunov,
        })
    }

    /// The states that are drawn: those asked for, else the one whose turns make the section, or the first that it leaves free.
    fn shown(&self, info: &ModelInfo, section: &Section) -> Result<Vec<usize>, Failure> {
        let free = match section.surface {
            Surface::Level { state, .. } => usize::from(state == 0 && info.states.len() > 1),
            Surface::Rate(_) if self.cut.of(info)?.is_some() => 0,
            Surface::Rate(state) => state,
        };
        Ok(self.show.states(info)?.unwrap_or_else(|| vec![free]))
    }
}

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    let Some(range) = &arguments.way.along else {
        return refuse!(
            "`diagram` needs `--along NAME=A..B`: which parameter, from where to where"
        );
    };
    let asked = request(app, &arguments.subject, Some(range), None)?;
    let (info, case, output) = (asked.info, &asked.case, &asked.output);
    let diagram = arguments.diagram(&asked)?;
    let shown = arguments.shown(info, &diagram.section)?;
    let (along, rows) = (asked.along()?, diagram.rows());
    let question = question(app, info, case, &diagram);
    let ledger: Ledger<Slice> =
        Ledger::open(&asked, &arguments.sharing, "diagram", question, rows)?;
    let papers = Mutex::new(Papers {
        info,
        along,
        points: ledger.journal(
            output,
            "points",
            &answer::points(info, &along, "", 0.0).head(),
        ),
        values: ledger.journal(output, "values", &answer::values(info, &along, "").head()),
    });
    let found = |item: &Item<'_, Slice>| {
        let mut papers = papers.lock().unwrap_or_else(PoisonError::into_inner);
        papers.take(diagram.sweep_of(item.number).name(), item.found);
        format!("{} = {}", along.name(info), number(item.found.r, 6))
    };
    let beginning = "looking for the first value";
    let record = ledger.answer(&asked, beginning, &found, |list, watch| {
        asked.entry.diagram_watched(case, &diagram, list, watch)
    })?;
    if ledger.is_shared() {
        return ledger.close(output, record.missing);
    }
    output.deliver(&answer::answer(info, case, &record, &shown))?;
    ledger.close(output, record.missing)?;
    failures(info, &record)
}

/// All values.
fn slices(record: &DiagramRecord) -> impl Iterator<Item = &Slice> {
    record.sweeps.iter().flat_map(|sweep| &sweep.slices)
}

/// What is asked, as far as the answer depends on it: not on the number of threads.
fn question(app: &App, info: &ModelInfo, case: &Case, diagram: &Diagram) -> Question {
    Question::new(app.version, info, case)
        .and("`--section`", diagram.section.describe(info))
        .exactly("the section", &diagram.section)
        .and("`--sweep`", diagram.sweep.name())
        .and("`--values`", diagram.values)
        .and("`--settle`", diagram.settle)
        .and("`--points`", diagram.points)
        .exactly("`--lyapunov`", &diagram.lyapunov)
}

/// What is written of each value as it is found.
struct Papers<'a> {
    info: &'a ModelInfo,
    along: Along,
    points: Journal,
    values: Journal,
}

impl Papers<'_> {
    fn take(&mut self, sweep: &str, slice: &Slice) {
        let (info, along) = (self.info, &self.along);
        self.points.add(answer::rows(info, along, sweep, slice));
        self.values
            .add([answer::values(info, along, sweep).row(slice)]);
    }
}

/// Values without an answer, if there are any.
fn failures(info: &ModelInfo, record: &DiagramRecord) -> Result<(), Failure> {
    let name = record.along.name(info);
    let failed: Vec<(f64, &str)> = slices(record)
        .filter_map(|slice| match &slice.motion {
            Motion::Failed(reason) => Some((slice.r, reason.as_str())),
            _ => None,
        })
        .collect();
    match failed.as_slice() {
        [] => Ok(()),
        [(r, reason), ..] => Err(Failure::failed(format!(
            "{} values have no answer, the first at {name} = {r}: {reason}",
            failed.len()
        ))),
    }
}
