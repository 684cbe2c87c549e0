//! `equilibria`: where the system can rest or slide evenly, and how stable that is.

mod answer;
mod proof;

use clap::Args;

use crate::app::arguments::{Curve, Subject, Unresumable, Way};
use crate::app::failure::{Failure, refuse};
use crate::app::offer::App;
use crate::app::progress::{Progress, Trail};
use crate::app::request::{Request, request};
use crate::study::{Along, EquilibriaRecord, EquilibriumRecord};
pub(super) use answer::branch;

/// What is done before anything is found.
pub(super) const FIRST: &str = "looking for the first equilibrium";

/// List equilibria with their eigenvalues; with --along, follow one and find its Hopf points and folds, with --and one of these in two parameters
#[derive(Debug, Clone, Args)]
#[command(
    after_help = "With --certify, those that cannot be proven are listed with the reason, and the exit code is 1 then"
)]
pub(in crate::app) struct Arguments {
    #[command(flatten)]
    pub(in crate::app::commands) subject: Subject,
    #[command(flatten)]
    pub(in crate::app::commands) way: Way,
    /// Prove each with interval arithmetic: a box that holds one equilibrium, and only one
    #[arg(long)]
    pub(in crate::app::commands) certify: bool,
    #[command(flatten)]
    pub(in crate::app::commands) curve: Curve,
    #[command(flatten)]
    pub(in crate::app::commands) resume: Unresumable,
}

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    arguments.resume.refuse()?;
    let range = arguments.way.along.as_ref();
    let request = request(app, &arguments.subject, range, None)?;
    match (request.case.along, arguments.certify) {
        (None, certify) => list(&request, certify),
        (Some(along), false) => follow(&request, along),
        (Some(_), true) => refuse!(
            "`--certify` proves the equilibria at one value of every parameter: leave `--along` out, and `--set` the value"
        ),
    }
}

fn list(asked: &Request<'_>, certify: bool) -> Result<(), Failure> {
    let (info, case) = (asked.info, &asked.case);
    let found = asked.got(asked.entry.equilibria(case))?;
    let proofs = certify.then(|| asked.entry.proofs(case, &found));
    let answer = answer::list(info, case, &found, proofs.as_deref());
    asked.output.deliver(&answer)?;
    proof::verdict(proofs.as_deref().unwrap_or_default())
}

fn follow(asked: &Request<'_>, along: Along) -> Result<(), Failure> {
    let progress = Progress::along(&asked.output, FIRST);
    let mut trail = trail(asked, along, &progress);
    let mut watch = |point: &EquilibriumRecord| trail.reach(point.r, point);
    let branch = asked
        .entry
        .equilibria_along_watched(&asked.case, &mut watch);
    drop(progress);
    deliver(asked, &asked.got(branch)?)
}

/// The equilibria of a branch as they are found.
pub(super) fn trail<'a>(
    asked: &Request<'_>,
    along: Along,
    progress: &'a Progress,
) -> Trail<'a, EquilibriumRecord> {
    let columns = answer::columns(asked.info, Some(&along));
    Trail::new(asked, along, "equilibria", columns, progress)
}

/// Answers with a branch.
///
/// # Errors
/// It ended before its range did, or the answer cannot be written.
pub(super) fn deliver(asked: &Request<'_>, found: &EquilibriaRecord) -> Result<(), Failure> {
    let output = &asked.output;
    output.deliver(&branch(asked.info, &asked.case, found))?;
    let count = format!("{} equilibria were found", found.points.len());
    output.close("branch", &found.ended, &count)
}
