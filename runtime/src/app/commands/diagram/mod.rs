//! `diagram`: where motions meet a section, for many values of a design variable.

mod answer;
mod arguments;
mod sheet;

use std::sync::{Mutex, PoisonError};

use crate::app::failure::Failure;
use crate::app::journal::Journal;
use crate::app::offer::App;
use crate::app::progress::Progress;
use crate::app::request::request;
use crate::app::resume::{Notes, Question};
use crate::model::ModelInfo;
use crate::study::{Along, Case, Diagram, DiagramRecord, Known, Motion, Seen, Slice};
pub(in crate::app) use arguments::Arguments;

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    let Some(range) = &arguments.way.along else {
        let message = "`diagram` needs `--along NAME=A..B`: which parameter, from where to where";
        return Err(Failure::usage(message));
    };
    let asked = request(app, &arguments.subject, Some(range), None)?;
    let (info, case, output) = (asked.info, &asked.case, &asked.output);
    let diagram = arguments.diagram(info)?;
    let shown = arguments.shown(info, &diagram.section)?;
    let progress = Progress::along(output);
    let mut known = Known::default();
    let mut recall = |finding: &[u8]| {
        let (sweep, slice): (String, Slice) = borsh::from_slice(finding).ok()?;
        known.insert(&sweep, slice);
        Some(())
    };
    let question = question(app, info, case, &diagram);
    let notes = Notes::open(output, &arguments.resume, "diagram", &question, &mut recall)?;
    let along = asked.along()?;
    let papers = Mutex::new(Papers {
        info,
        along,
        points: output.journal("points", sheet::points(info, &along, "", 0.0).head()),
        values: output.journal("values", sheet::values(info, &along, "").head()),
        notes,
    });
    let watch = |seen: Seen<'_>| {
        let mut papers = papers.lock().unwrap_or_else(PoisonError::into_inner);
        papers.take(&seen);
        progress.reach(seen.share, String::new())
    };
    let record = asked.entry.diagram(case, &diagram, &known, &watch);
    let record = record.map_err(|error| asked.failed(error))?;
    drop(progress);
    output.deliver(answer::answer(info, case, &record, shown))?;
    if record.missing > 0 {
        let count = slices(&record).count();
        return Err(output.interrupted(&format!("{count} values were found")));
    }
    let papers = papers.into_inner().unwrap_or_else(PoisonError::into_inner);
    papers.notes.discard();
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
    notes: Notes,
}

impl Papers<'_> {
    fn take(&mut self, seen: &Seen<'_>) {
        let Seen { sweep, slice, .. } = *seen;
        let (info, along) = (self.info, &self.along);
        if !seen.known {
            self.notes.add(borsh::to_vec(&(sweep, slice)).ok());
        }
        self.points.add(sheet::rows(info, along, sweep, slice));
        self.values
            .add([sheet::values(info, along, sweep).row(slice)]);
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
