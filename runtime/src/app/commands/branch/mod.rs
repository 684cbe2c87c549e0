//! `branch`: orbits along a design variable.

mod arguments;
mod document;
mod picture;
mod sheet;
mod text;

use std::ops::ControlFlow;

use crate::app::failure::Failure;
use crate::app::offer::App;
use crate::app::passages::Passages;
use crate::app::progress::Progress;
use crate::app::request::{Request, request};
use crate::app::resume::Question;
use crate::app::trail::Trail;
use crate::study::{BranchRecord, Ended, OrbitRecord};
pub(in crate::app) use arguments::{Arguments, Shown};

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    let range = arguments.range()?;
    let mut asked = request(app, &arguments.subject, Some(range), arguments.guess.period)?;
    let shown = arguments.shown(asked.info)?;
    asked.case = arguments.of(asked.info, asked.case)?;
    let progress = Progress::along(&asked.output);
    let question =
        Question::new(app.version, asked.info, &asked.case).exactly("`--harmonics`", &shown.orders);
    let mut passages = Passages::open(&asked.output, &arguments.resume, "branch", &question)?;
    let mut trail = trail(&asked, &progress)?;
    let mut watch = |point: &OrbitRecord| found(&asked, &mut trail, point);
    let branch = passages
        .recorded(asked.entry)
        .branch(&asked.case, &mut watch);
    let branch = branch.map_err(|error| asked.failed(error))?;
    drop(progress);
    deliver(&asked, &branch, &shown)?;
    passages.discard();
    let reason = |ended: &Ended| format!("the branch ended, {}: {}", ended.word(), ended.reason);
    if let Some(ended) = branch.unlocated() {
        return Err(Failure::failed(reason(ended)));
    }
    asked.output.note(reason(&branch.ended));
    Ok(())
}

/// The orbits of a branch as they are found.
pub(super) fn trail<'a>(asked: &Request<'_>, progress: &'a Progress) -> Result<Trail<'a>, Failure> {
    let along = asked.along()?;
    let head = sheet::head(asked.info, &along, &asked.case.harmonics);
    Ok(Trail::new(asked, along, "branch", head, progress))
}

/// One more orbit of a branch.
pub(super) fn found(
    asked: &Request<'_>,
    trail: &mut Trail<'_>,
    point: &OrbitRecord,
) -> ControlFlow<()> {
    match point.r {
        Some(r) => trail.reach(r, sheet::row(point, asked.info, &asked.case.harmonics)),
        None => ControlFlow::Continue(()),
    }
}

/// Answers with a branch.
///
/// # Errors
/// It was interrupted, or the answer cannot be written.
pub(super) fn deliver(
    asked: &Request<'_>,
    branch: &BranchRecord,
    shown: &Shown,
) -> Result<(), Failure> {
    let (info, case, output) = (asked.info, &asked.case, &asked.output);
    let document = document::document(info, case, branch);
    let drawn = output.draw([("branch", picture::picture(info, branch, shown))]);
    let text = text::describe(info, case, branch, shown);
    output.deliver(
        "branch",
        &text,
        &document,
        &sheet::sheets(info, branch, &shown.orders),
    )?;
    drawn?;
    if branch.is_interrupted() {
        let count: usize = branch.all().iter().map(|one| one.points.len()).sum();
        return Err(output.interrupted(&format!("{count} orbits were found")));
    }
    Ok(())
}

/// Writes a branch to the folder, if there is one, beside the answer.
pub(super) fn keep(
    asked: &Request<'_>,
    branch: &BranchRecord,
    shown: &Shown,
) -> Result<(), Failure> {
    let (info, case, output) = (asked.info, &asked.case, &asked.output);
    let document = document::document(info, case, branch);
    output.draw([("branch", picture::picture(info, branch, shown))])?;
    output.keep(
        "branch",
        &document,
        &sheet::sheets(info, branch, &shown.orders),
    )
}
