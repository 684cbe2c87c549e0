//! `equilibria`: where the system can rest or slide evenly, and how stable that is.

mod answer;
mod proof;

use clap::Args;

use crate::app::arguments::{Subject, Unresumable, Way};
use crate::app::failure::{Failure, refuse};
use crate::app::offer::App;
use crate::app::progress::{Progress, Trail};
use crate::app::request::{Request, request};
use crate::study::{Along, EquilibriumRecord};

/// List equilibria with their eigenvalues; with --along, follow one and find its Hopf points and folds
#[derive(Debug, Clone, Args)]
#[command(
    after_help = "With --certify, those that cannot be proven are listed with the reason, and the exit code is 1 then"
)]
pub(in crate::app) struct Arguments {
    #[command(flatten)]
    subject: Subject,
    #[command(flatten)]
    way: Way,
    /// Prove each with interval arithmetic: a box that holds one equilibrium, and only one
    #[arg(long)]
    certify: bool,
    #[command(flatten)]
    resume: Unresumable,
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
    let (info, case, output) = (asked.info, &asked.case, &asked.output);
    let progress = Progress::along(output, "looking for the first equilibrium");
    let columns = answer::columns(info, Some(&along));
    let mut trail = Trail::new(asked, along, "equilibria", columns, &progress);
    let mut watch = |point: &EquilibriumRecord| trail.reach(point.r, point);
    let branch = asked.got(asked.entry.equilibria_along_watched(case, &mut watch))?;
    drop(progress);
    output.deliver(&answer::branch(info, case, &branch))?;
    let found = format!("{} equilibria were found", branch.points.len());
    output.close("branch", &branch.ended, &found)
}
