//! `equilibria`: where the system can rest or slide evenly, and how stable that is.

mod proof;

use std::ops::ControlFlow;

use clap::ArgMatches;
use nalgebra::Complex;

use super::App;
use super::failure::Failure;
use super::json;
use super::options::{Request, request};
use super::picture;
use super::progress::Progress;
use super::spreadsheet::Spreadsheet;
use super::text::{followed, label, number, parameters, table, time_unit, timed};
use crate::model::ModelInfo;
use crate::study::{Case, EquilibriaRecord, EquilibriumRecord, SpecialEquilibrium};

const DIGITS: usize = 9;

pub(super) fn perform(app: &App, options: &ArgMatches) -> Result<(), Failure> {
    let request = request(app, options)?;
    match (request.case.along, options.get_flag("certify")) {
        (None, certify) => list(&request, certify),
        (Some(_), false) => follow(&request),
        (Some(_), true) => Err(Failure::usage(
            "`--certify` proves the equilibria at one value of every parameter: leave `--along` out, and `--set` the value",
        )),
    }
}

fn list(request: &Request<'_>, certify: bool) -> Result<(), Failure> {
    let Request {
        entry,
        case,
        output,
    } = request;
    let info = entry.info();
    let found = entry
        .equilibria(case)
        .map_err(|error| Failure::of(&error, info))?;
    let title = format!("{}, {}: equilibria\n", info.command, case.dynamics);
    let mut text = format!("{title}  {}\n\n", parameters(info, case));
    text.push_str(&table(&rows(info, None, &found)));
    text.push_str(&remarks(case, found.iter().any(|one| one.artefact), false));
    let proofs = certify.then(|| entry.proofs(case, &found));
    if let Some(proofs) = &proofs {
        text.push_str(&proof::describe(info, proofs));
    }
    let sheet = Spreadsheet::equilibria(info, "", &found);
    let document = json::Equilibria::new(info, case, &found).with_proofs(info, proofs.as_deref());
    output.deliver("equilibria", &text, &document, &[("equilibria", sheet)])?;
    proof::verdict(proofs.as_deref().unwrap_or_default())
}

fn follow(request: &Request<'_>) -> Result<(), Failure> {
    let Request {
        entry,
        case,
        output,
    } = request;
    let info = entry.info();
    let progress = Progress::along(output);
    let mut journal = output.journal("equilibria");
    let mut watch = |point: &EquilibriumRecord| {
        let (Some(along), Some(r)) = (case.along, point.r) else {
            return ControlFlow::Continue(());
        };
        let name = followed(info, &along);
        journal.add(|| Spreadsheet::equilibria(info, &name, std::slice::from_ref(point)));
        let message = format!("{} = {}", along.name(info), number(r, 6));
        progress.reach(along.share(r), message)
    };
    let branch = entry
        .equilibria_along(case, &mut watch)
        .map_err(|error| Failure::of(&error, info))?;
    drop(progress);
    let sheet = Spreadsheet::equilibria(info, &followed(info, &branch.along), &branch.points);
    let document = json::EquilibriumBranch::new(info, case, &branch);
    let text = describe(info, case, &branch);
    let drawn = output.draw([("equilibria", picture::equilibria(info, &branch))]);
    let delivered = output.deliver("equilibria", &text, &document, &[("equilibria", sheet)]);
    delivered.and(drawn)?;
    let found = format!("{} equilibria were found", branch.points.len());
    output.close("branch", &branch.ended, &found)
}

fn describe(info: &ModelInfo, case: &Case, branch: &EquilibriaRecord) -> String {
    let (name, along) = (branch.along.name(info), followed(info, &branch.along));
    let mut text = format!(
        "{}, {}: a branch of equilibria along {name}\n  {}\n\n",
        info.command,
        case.dynamics,
        parameters(info, case)
    );
    text.push_str(&table(&rows(info, Some(&along), &branch.points)));
    if !branch.special.is_empty() {
        text.push_str(&format!("\n{}", table(&special(info, &along, branch))));
    }
    let points = branch.points.iter().any(|point| point.artefact);
    let special = branch.special.iter().any(|point| point.artefact);
    text.push_str(&remarks(case, points, special));
    text
}

fn rows(info: &ModelInfo, name: Option<&str>, all: &[EquilibriumRecord]) -> Vec<Vec<String>> {
    let states = info
        .states
        .iter()
        .map(|state| label(state.name, state.unit));
    let modes = all.iter().any(|one| one.mode.is_some());
    let mut head: Vec<String> = name.map(str::to_owned).into_iter().chain(states).collect();
    head.push(timed(info, "eigenvalues", "1/s"));
    head.push("stability".to_owned());
    if modes {
        head.push("mode".to_owned());
    }
    let row = |one: &EquilibriumRecord| {
        let mut row: Vec<String> = one.r.map(|r| number(r, DIGITS)).into_iter().collect();
        row.extend((0..info.states.len()).map(|j| state(one, j)));
        row.push(eigenvalues(&one.eigenvalues));
        let mark = if one.artefact { " *" } else { "" };
        row.push(format!("{}{mark}", one.stability.name()));
        row.extend(one.mode.clone());
        row
    };
    std::iter::once(head).chain(all.iter().map(row)).collect()
}

/// A state, or the interval that it covers in a set.
fn state(one: &EquilibriumRecord, j: usize) -> String {
    let at = |values: &[f64]| values.get(j).map_or(String::new(), |&value| rounded(value));
    match &one.set {
        Some(set) if at(&set.low) != at(&set.high) => {
            format!("[{}, {}]", at(&set.low), at(&set.high))
        }
        _ => at(&one.state),
    }
}

/// A state is not known better than to rounding.
fn rounded(value: f64) -> String {
    let nothing = value.abs() < 1e-14;
    number(if nothing { 0.0 } else { value }, DIGITS)
}

fn eigenvalues(all: &[Complex<f64>]) -> String {
    let short = |value: f64| number(value, 5);
    let one = |value: &Complex<f64>| match value.im {
        im if im > 0.0 => Some(format!("{} ± {}i", short(value.re), short(im))),
        im if im < 0.0 => None,
        _ => Some(short(value.re)),
    };
    all.iter().filter_map(one).collect::<Vec<_>>().join(", ")
}

fn special(info: &ModelInfo, name: &str, branch: &EquilibriaRecord) -> Vec<Vec<String>> {
    let head = ["special", "kind", name, "period"].map(str::to_owned);
    let time = time_unit(info);
    let row = |point: &SpecialEquilibrium| {
        let mark = if point.artefact { " *" } else { "" };
        vec![
            point.label.clone(),
            format!("{}{mark}", point.kind),
            number(point.r, 10),
            point
                .period
                .map_or_else(|| "-".to_owned(), |period| number(period, 10) + time),
        ]
    };
    std::iter::once(head.to_vec())
        .chain(branch.special.iter().map(row))
        .collect()
}

fn remarks(case: &Case, points: bool, special: bool) -> String {
    let what = match (points, special) {
        (false, false) => return String::new(),
        (true, false) => "the exact system has no equilibrium there, or one of the other stability",
        (false, true) => "the exact system has no such point there",
        (true, true) => {
            "the exact system has no such point there, and an equilibrium, if any, of the other stability"
        }
    };
    format!(
        "\n  * artefact of smoothing, {} only: {what}\n",
        case.dynamics
    )
}
