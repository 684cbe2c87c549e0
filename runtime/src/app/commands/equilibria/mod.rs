//! `equilibria`: where the system can rest or slide evenly, and how stable that is.

mod arguments;
mod document;
mod picture;
mod proof;
mod sheet;
mod text;

use std::ops::ControlFlow;

use crate::app::failure::Failure;
use crate::app::offer::App;
use crate::app::progress::Progress;
use crate::app::request::{Request, request};
use crate::app::spreadsheet::Spreadsheet;
use crate::app::trail::Trail;
use crate::study::{Along, EquilibriumRecord};
pub(in crate::app) use arguments::Arguments;

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    arguments.resume.refuse()?;
    let range = arguments.way.along.as_ref();
    let request = request(app, &arguments.subject, range, None)?;
    match (request.case.along, arguments.certify) {
        (None, certify) => list(&request, certify),
        (Some(along), false) => follow(&request, along),
        (Some(_), true) => Err(Failure::usage(
            "`--certify` proves the equilibria at one value of every parameter: leave `--along` out, and `--set` the value",
        )),
    }
}

fn list(asked: &Request<'_>, certify: bool) -> Result<(), Failure> {
    let (info, case) = (asked.info, &asked.case);
    let found = asked.entry.equilibria(case);
    let found = found.map_err(|error| asked.failed(error))?;
    let mut text = text::list(info, case, &found);
    let mut proofs = Vec::new();
    if certify {
        proofs = asked.entry.proofs(case, &found);
        text.push_str(&proof::describe(info, &proofs));
    }
    let sheet = Spreadsheet::new(sheet::head(info, None), found.iter().map(sheet::row));
    let document = document::list(info, case, &found, &proofs);
    asked
        .output
        .deliver("equilibria", &text, &document, &[("equilibria", sheet)])?;
    proof::verdict(&proofs)
}

fn follow(asked: &Request<'_>, along: Along) -> Result<(), Failure> {
    let (info, case, output) = (asked.info, &asked.case, &asked.output);
    let progress = Progress::along(output);
    let head = sheet::head(info, Some(&along));
    let mut trail = Trail::new(asked, along, "equilibria", head.clone(), &progress);
    let mut watch = |point: &EquilibriumRecord| match point.r {
        Some(r) => trail.reach(r, sheet::row(point)),
        None => ControlFlow::Continue(()),
    };
    let branch = asked.entry.equilibria_along(case, &mut watch);
    let branch = branch.map_err(|error| asked.failed(error))?;
    drop(progress);
    let sheet = Spreadsheet::new(head, branch.points.iter().map(sheet::row));
    let document = document::branch(info, case, &branch);
    let text = text::describe(info, case, &branch);
    let drawn = output.draw([("equilibria", picture::picture(info, &branch))]);
    let delivered = output.deliver("equilibria", &text, &document, &[("equilibria", sheet)]);
    delivered.and(drawn)?;
    let found = format!("{} equilibria were found", branch.points.len());
    output.close("branch", &branch.ended, &found)
}
