//! `branch`: orbits along a design variable.

mod arguments;
mod document;
mod picture;
mod sheet;
mod text;

use std::ops::ControlFlow;

use super::curve;
use crate::app::App;
use crate::app::failure::Failure;
use crate::app::journal::Journal;
use crate::app::output::Output;
use crate::app::passages::Passages;
use crate::app::progress::Progress;
use crate::app::request::{Request, request};
use crate::app::resume::Question;
use crate::app::text::number;
use crate::model::ModelInfo;
use crate::study::{Along, BranchRecord, Case, Ended, OrbitRecord};
pub(in crate::app) use arguments::Arguments;

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    let Some(range) = &arguments.way.along else {
        let message = "`branch` needs `--along NAME=A..B`: what to follow, from where to where";
        return Err(Failure::usage(message));
    };
    let curve = curve::wanted(arguments)?;
    let asked = request(app, &arguments.subject, Some(range), arguments.guess.period)?;
    if let Some(and) = curve {
        return curve::perform(app, asked, and, arguments);
    }
    let Request {
        entry,
        info,
        case,
        output,
    } = asked;
    let case = arguments.of(case)?;
    let question = Question::new(app.version, info, &case);
    let resume = arguments.resume.resume;
    let mut passages = Passages::open(&output, resume, "branch", &question)?;
    let progress = Progress::along(&output);
    let mut rows = Rows::new(&output, info, &case);
    let mut watch = |point: &OrbitRecord| rows.add(point, &progress);
    let branch = passages.through(|tape| entry.branch(&case, tape, &mut watch));
    let branch = branch.map_err(|error| Failure::of(&error, info))?;
    drop(progress);
    deliver(&output, info, &case, &branch)?;
    passages.discard();
    let reason = |ended: &Ended| format!("the branch ended, {}: {}", ended.word, ended.reason);
    if let Some(ended) = branch.unlocated() {
        return Err(Failure::failed(reason(ended)));
    }
    output.note(reason(&branch.ended));
    Ok(())
}

/// What is written and shown of each orbit as it is found.
pub(super) struct Rows<'a> {
    info: &'a ModelInfo,
    kept: Option<(Along, Journal)>,
}

impl<'a> Rows<'a> {
    pub(super) fn new(output: &Output, info: &'a ModelInfo, case: &Case) -> Self {
        let kept = case.along.map(|along| {
            let journal = output.journal("branch", sheet::head(info, &along));
            (along, journal)
        });
        Self { info, kept }
    }

    pub(super) fn add(&mut self, point: &OrbitRecord, progress: &Progress) -> ControlFlow<()> {
        let (Some((along, journal)), Some(r)) = (&mut self.kept, point.r) else {
            return ControlFlow::Continue(());
        };
        journal.add([sheet::row(point)]);
        let message = format!("{} = {}", along.name(self.info), number(r, 6));
        progress.reach(along.share(r), message)
    }
}

/// Answers with a branch.
///
/// # Errors
/// It was interrupted, or the answer cannot be written.
pub(super) fn deliver(
    output: &Output,
    info: &ModelInfo,
    case: &Case,
    branch: &BranchRecord,
) -> Result<(), Failure> {
    let document = document::document(info, case, branch);
    let drawn = output.draw([("branch", picture::picture(info, branch))]);
    let text = text::describe(info, case, branch);
    output.deliver("branch", &text, &document, &sheet::sheets(info, branch))?;
    drawn?;
    if branch.is_interrupted() {
        let count: usize = branch.all().iter().map(|one| one.points.len()).sum();
        return Err(output.interrupted(&format!("{count} orbits were found")));
    }
    Ok(())
}

/// Writes a branch to the folder, if there is one, beside the answer.
pub(super) fn keep(
    output: &Output,
    info: &ModelInfo,
    case: &Case,
    branch: &BranchRecord,
) -> Result<(), Failure> {
    let document = document::document(info, case, branch);
    output.draw([("branch", picture::picture(info, branch))])?;
    output.keep("branch", &document, &sheet::sheets(info, branch))
}
