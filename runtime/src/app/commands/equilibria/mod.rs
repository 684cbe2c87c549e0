//! `equilibria`: where the system can rest or slide evenly, and how stable that is.

mod arguments;
mod document;
mod picture;
mod proof;
mod sheet;
mod text;

use std::ops::ControlFlow;

use crate::app::App;
use crate::app::failure::Failure;
use crate::app::progress::Progress;
use crate::app::request::{Request, request};
use crate::app::spreadsheet::Spreadsheet;
use crate::app::text::number;
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

fn list(request: &Request<'_>, certify: bool) -> Result<(), Failure> {
    let Request {
        entry,
        info,
        case,
        output,
    } = request;
    let found = entry
        .equilibria(case)
        .map_err(|error| Failure::of(&error, info))?;
    let mut text = text::list(info, case, &found);
    let proofs = certify.then(|| entry.proofs(case, &found));
    if let Some(proofs) = &proofs {
        text.push_str(&proof::describe(info, proofs));
    }
    let proofs = proofs.unwrap_or_default();
    let sheet = Spreadsheet::new(sheet::head(info, None), found.iter().map(sheet::row));
    let document = document::list(info, case, &found, &proofs);
    output.deliver("equilibria", &text, &document, &[("equilibria", sheet)])?;
    proof::verdict(&proofs)
}

fn follow(request: &Request<'_>, along: Along) -> Result<(), Failure> {
    let Request {
        entry,
        info,
        case,
        output,
    } = request;
    let progress = Progress::along(output);
    let head = sheet::head(info, Some(&along));
    let mut journal = output.journal("equilibria", head.clone());
    let mut watch = |point: &EquilibriumRecord| {
        let Some(r) = point.r else {
            return ControlFlow::Continue(());
        };
        journal.add([sheet::row(point)]);
        let message = format!("{} = {}", along.name(info), number(r, 6));
        progress.reach(along.share(r), message)
    };
    let branch = entry
        .equilibria_along(case, &mut watch)
        .map_err(|error| Failure::of(&error, info))?;
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
