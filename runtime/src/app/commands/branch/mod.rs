//! `branch`: orbits along a design variable.

mod answer;
mod arguments;

use super::orbit;
use crate::app::failure::Failure;
use crate::app::offer::App;
use crate::app::passages::Passages;
use crate::app::progress::Progress;
use crate::app::request::{Request, request};
use crate::app::resume::Question;
use crate::app::trail::Trail;
use crate::study::{BranchRecord, Ended, OrbitRecord};
pub(super) use answer::answer;
pub(in crate::app) use arguments::Arguments;

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    let range = arguments.range()?;
    let mut asked = request(app, &arguments.subject, Some(range), arguments.guess.period)?;
    asked.case = arguments.of(asked.case)?;
    let progress = Progress::along(&asked.output);
    let question = Question::new(app.version, asked.info, &asked.case);
    let mut passages = Passages::open(&asked.output, &arguments.resume, "branch", &question)?;
    let mut trail = trail(&asked, &progress)?;
    let mut watch = |point: &OrbitRecord| trail.reach(point.r, point);
    let branch = passages
        .recorded(asked.entry)
        .branch(&asked.case, &mut watch);
    let branch = branch.map_err(|error| asked.failed(error))?;
    drop(progress);
    deliver(&asked, &branch)?;
    passages.discard();
    let reason = |ended: &Ended| format!("the branch ended, {}: {}", ended.word(), ended.reason);
    if let Some(ended) = branch.unlocated() {
        return Err(Failure::failed(reason(ended)));
    }
    asked.output.note(reason(&branch.ended));
    Ok(())
}

/// The orbits of a branch as they are found.
pub(super) fn trail<'a>(
    asked: &Request<'_>,
    progress: &'a Progress,
) -> Result<Trail<'a, OrbitRecord>, Failure> {
    let along = asked.along()?;
    let columns = orbit::columns(asked.info, &along);
    Ok(Trail::new(asked, along, "branch", columns, progress))
}

/// Answers with a branch.
///
/// # Errors
/// It was interrupted, or the answer cannot be written.
pub(super) fn deliver(asked: &Request<'_>, branch: &BranchRecord) -> Result<(), Failure> {
    asked.output.deliver(answer(asked, branch))?;
    if branch.is_interrupted() {
        let count: usize = branch.all().iter().map(|one| one.points.len()).sum();
        return Err(asked
            .output
            .interrupted(&format!("{count} orbits were found")));
    }
    Ok(())
}
