//! `diagram`: where motions meet a section, for many values of a design variable.

mod arguments;
mod document;
mod picture;
mod sheet;
mod text;

use std::sync::{Mutex, PoisonError};

use crate::app::failure::Failure;
use crate::app::journal::Journal;
use crate::app::offer::App;
use crate::app::progress::Progress;
use crate::app::request::{Request, request};
use crate::app::resume::{Notes, Question};
use crate::app::spreadsheet::Spreadsheet;
use crate::app::text::followed;
use crate::model::ModelInfo;
use crate::report::Figure;
use crate::study::{Case, Diagram, DiagramRecord, Known, Motion, Seen, Slice};
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
        let (sweep, slice): (String, Slice) = postcard::from_bytes(finding).ok()?;
        known.insert(&sweep, slice);
        Some(())
    };
    let question = question(app, info, case, &diagram);
    let notes = Notes::open(output, &arguments.resume, "diagram", &question, &mut recall)?;
    let along = followed(info, &asked.along()?);
    let papers = Mutex::new(Papers {
        states: info.states.len(),
        points: output.journal("points", sheet::points_head(info, &along)),
        values: output.journal("values", sheet::values_head(info, &along)),
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
    let picture = picture::picture(info, &record, shown);
    deliver(&asked, &record, picture)?;
    let papers = papers.into_inner().unwrap_or_else(PoisonError::into_inner);
    papers.notes.discard();
    failures(info, &record)
}

fn deliver(asked: &Request<'_>, record: &DiagramRecord, picture: Figure) -> Result<(), Failure> {
    let (info, case, output) = (asked.info, &asked.case, &asked.output);
    let drawn = output.draw([("diagram", picture)]);
    let (text, document) = (
        text::describe(info, case, record),
        document::document(info, case, record),
    );
    let delivered = output.deliver("diagram", &text, &document, &sheets(info, record));
    delivered.and(drawn)?;
    if record.missing > 0 {
        let count = slices(record).count();
        return Err(output.interrupted(&format!("{count} values were found")));
    }
    Ok(())
}

/// All values with the names of their sweeps.
fn slices(record: &DiagramRecord) -> impl Iterator<Item = (&'static str, &Slice)> {
    let sweeps = record.sweeps.iter();
    sweeps.flat_map(|sweep| sweep.slices.iter().map(|slice| (sweep.name, slice)))
}

fn sheets(info: &ModelInfo, record: &DiagramRecord) -> [(&'static str, Spreadsheet); 2] {
    let (name, states) = (followed(info, &record.along), info.states.len());
    let points = slices(record).flat_map(|(sweep, slice)| sheet::points(sweep, slice));
    let values = slices(record).map(|(sweep, slice)| sheet::value(sweep, slice, states));
    [
        (
            "points",
            Spreadsheet::new(sheet::points_head(info, &name), points),
        ),
        (
            "values",
            Spreadsheet::new(sheet::values_head(info, &name), values),
        ),
    ]
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
struct Papers {
    states: usize,
    points: Journal,
    values: Journal,
    notes: Notes,
}

impl Papers {
    fn take(&mut self, seen: &Seen<'_>) {
        let Seen { sweep, slice, .. } = *seen;
        if !seen.known {
            self.notes.add(postcard::to_allocvec(&(sweep, slice)).ok());
        }
        self.points.add(sheet::points(sweep, slice));
        self.values.add([sheet::value(sweep, slice, self.states)]);
    }
}

/// Values without an answer, if there are any.
fn failures(info: &ModelInfo, record: &DiagramRecord) -> Result<(), Failure> {
    let name = record.along.name(info);
    let slices = slices(record).map(|(_, slice)| slice);
    let failed: Vec<(f64, &str)> = slices
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
