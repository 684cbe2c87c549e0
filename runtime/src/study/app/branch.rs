//! `branch`: orbits along a design variable.

use clap::ArgMatches;

use super::App;
use super::failure::Failure;
use super::json;
use super::options::{Request, request, text};
use super::progress::Progress;
use super::spreadsheet::Spreadsheet;
use super::text::{digits, number, parameters, table};
use crate::model::ModelInfo;
use crate::study::{BranchRecord, Case, OrbitRecord};

pub(super) fn perform(app: &App, options: &ArgMatches) -> Result<(), Failure> {
    if text(options, "along").is_none() {
        let message = "`branch` needs `--along NAME=A..B`: what to follow, from where to where";
        return Err(Failure::usage(message));
    }
    let Request {
        entry,
        case,
        output,
    } = request(app, options)?;
    let info = entry.info();
    let progress = Progress::along(&output);
    let mut watch = |point: &OrbitRecord| {
        if let (Some(along), Some(r)) = (case.along, point.r) {
            let message = format!("{} = {}", along.name(info), number(r, 6));
            progress.reach(along.share(r), message);
        }
    };
    let branch = entry
        .branch(&case, &mut watch)
        .map_err(|error| Failure::of(&error, info))?;
    drop(progress);
    let sheet = Spreadsheet::orbits(info, branch.along.name(info), &branch.points);
    let document = json::Branch::new(info, &case, &branch);
    output.deliver(
        "branch",
        &describe(info, &case, &branch),
        &document,
        &[("branch", sheet)],
    )?;
    let reason = format!(
        "the branch ended, {}: {}",
        branch.ended.word, branch.ended.reason
    );
    if !branch.ended.located {
        return Err(Failure::failed(reason));
    }
    output.note(reason);
    Ok(())
}

fn describe(info: &ModelInfo, case: &Case, branch: &BranchRecord) -> String {
    let name = branch.along.name(info);
    let mut text = format!(
        "{}, {}: a branch of periodic orbits along {name}\n",
        info.command, case.dynamics
    );
    text.push_str(&format!("  {}\n\n", parameters(info, case)));
    text.push_str(&table(&points(info, name, branch)));
    if !branch.special.is_empty() {
        text.push_str(&format!("\n{}", table(&special(name, branch))));
    }
    text
}

fn points(info: &ModelInfo, name: &str, branch: &BranchRecord) -> Vec<Vec<String>> {
    let first = info.states.first().map_or("", |state| state.name);
    let head = [
        name,
        "period",
        &format!("max |{first}|"),
        "|multiplier|",
        "stability",
    ]
    .map(str::to_owned);
    let mut rows = vec![head.to_vec()];
    rows.extend(branch.points.iter().map(point));
    rows
}

fn point(orbit: &OrbitRecord) -> Vec<String> {
    let digits = digits(orbit.error_estimate).min(9);
    let largest = orbit.floquet.multipliers.first();
    vec![
        orbit.r.map_or(String::new(), |r| number(r, digits)),
        number(orbit.period, digits),
        orbit
            .max_abs
            .first()
            .map_or(String::new(), |&value| number(value, digits)),
        largest.map_or(String::new(), |multiplier| number(multiplier.norm(), 5)),
        orbit.floquet.stability.name().to_owned(),
    ]
}

fn special(name: &str, branch: &BranchRecord) -> Vec<Vec<String>> {
    let mut rows = vec![
        ["special", "kind", name, "period"]
            .map(str::to_owned)
            .to_vec(),
    ];
    rows.extend(branch.special.iter().map(|point| {
        vec![
            point.label.clone(),
            point.kind.to_owned(),
            number(point.r, 10),
            number(point.period, 10),
        ]
    }));
    rows
}
