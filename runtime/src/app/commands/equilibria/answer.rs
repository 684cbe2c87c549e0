//! Equilibria in all forms.

use nalgebra::Complex;

use super::proof;
use crate::app::answer::Answer;
use crate::app::axis::{along_axis, axis};
use crate::app::document::Document;
use crate::app::spreadsheet::{Columns, part, parts};
use crate::app::text::{followed, heading, located, number, states, time_unit, timed};
use crate::equilibrium::{Proof, Unproven};
use crate::model::ModelInfo;
use crate::report::chart::{Chart, Drawn, Mark, Point};
use crate::report::{Figure, Panel};
use crate::study::{Along, Case, EquilibriaRecord, EquilibriumRecord, SpecialEquilibrium};

const DIGITS: usize = 9;

/// A list of equilibria, with proofs if they were asked for.
pub(super) fn list<'a>(
    info: &'a ModelInfo,
    case: &'a Case,
    found: &'a [EquilibriumRecord],
    proofs: Option<&'a [Result<Proof, Unproven>]>,
) -> Answer<'a> {
    Answer::new(
        "equilibria",
        move || describe(info, case, found, proofs),
        move || document(info, case, found, proofs),
    )
    .sheet("equilibria", move || columns(info, None).sheet(found))
}

fn describe(
    info: &ModelInfo,
    case: &Case,
    found: &[EquilibriumRecord],
    proofs: Option<&[Result<Proof, Unproven>]>,
) -> String {
    let mut text = heading(info, case, "equilibria")
        + &shown(info, None, found).text(found)
        + &remarks(case, found.iter().any(|one| one.artefact), false);
    if let Some(proofs) = proofs {
        text.push_str(&proof::describe(info, proofs));
    }
    text
}

fn document<'a>(
    info: &'a ModelInfo,
    case: &Case,
    found: &[EquilibriumRecord],
    proofs: Option<&[Result<Proof, Unproven>]>,
) -> Document<'a> {
    let one = |(i, one)| {
        let proof = proofs.and_then(|proofs| proofs.get(i));
        let proof = proof.map(|proof| proof::document(info, proof));
        equilibrium(info, one).maybe("certificate", proof)
    };
    let all = found.iter().enumerate();
    Document::case(info, case)
        .list("equilibria", all, one)
        .units()
}

/// A branch of equilibria.
pub(in crate::app::commands) fn branch<'a>(
    info: &'a ModelInfo,
    case: &'a Case,
    branch: &'a EquilibriaRecord,
) -> Answer<'a> {
    Answer::new(
        "equilibria",
        || describe_branch(info, case, branch),
        || branch_document(info, case, branch),
    )
    .figure("equilibria", || picture(info, branch))
    .sheet("equilibria", || {
        columns(info, Some(&branch.along)).sheet(&branch.points)
    })
}

fn describe_branch(info: &ModelInfo, case: &Case, branch: &EquilibriaRecord) -> String {
    let (name, along) = (branch.along.name(info), followed(info, &branch.along));
    let mut text = heading(info, case, &format!("a branch of equilibria along {name}"));
    text += &shown(info, Some(&along), &branch.points).text(&branch.points);
    if !branch.special.is_empty() {
        text += &format!("\n{}", special(info, &along).text(&branch.special));
    }
    text += &others(info, branch);
    let points = branch.points.iter().any(|point| point.artefact);
    let special = branch.special.iter().any(|point| point.artefact);
    text + &remarks(case, points, special)
}

/// What there is where the branch begins and is not followed.
fn others(info: &ModelInfo, branch: &EquilibriaRecord) -> String {
    let Some(r) = branch.points.first().and_then(|point| point.r) else {
        return String::new();
    };
    if branch.others.is_empty() {
        return String::new();
    }
    let (count, name) = (branch.others.len(), branch.along.name(info));
    let more = match count {
        1 => "is one equilibrium more, which".to_owned(),
        _ => format!("are {count} equilibria more, which"),
    };
    format!(
        "\n  at {name} = {} there {more} this branch does not pass; `--start` begins at the one next to it:\n{}",
        number(r, DIGITS),
        shown(info, None, &branch.others).text(&branch.others)
    )
}

fn branch_document<'a>(
    info: &'a ModelInfo,
    case: &Case,
    branch: &EquilibriaRecord,
) -> Document<'a> {
    let special = |one: &SpecialEquilibrium| Document::of(info, one).by_state(&["state"]);
    Document::case(info, case)
        .range("along", &branch.along)
        .list("points", &branch.points, |one| equilibrium(info, one))
        .list("special", &branch.special, special)
        .list("others", &branch.others, |one| equilibrium(info, one))
        .ended(&branch.ended)
        .units()
        .put("work", branch.work)
}

/// All columns; the first is what is followed, if anything is.
pub(super) fn columns(
    info: &ModelInfo,
    along: Option<&Along>,
) -> Columns<'static, EquilibriumRecord> {
    let along = along.map(|along| followed(info, along));
    let eigenvalues = parts("eigenvalue", info.states.len(), &["re", "im"]);
    let eigenvalues = eigenvalues.iter().map(|part| timed(info, part, "1/s"));
    Columns::new()
        .numbers(along, |one: &EquilibriumRecord, _| one.r)
        .numbers(states(info, ""), |one, j| one.state.get(j).copied())
        .numbers(eigenvalues, |one, j| part(&one.eigenvalues, j))
        .column("stability", |one| one.stability.name())
        .column("mode", |one| one.mode.clone().unwrap_or_default())
        .truth("artefact", |one| one.artefact)
}

/// The columns on the terminal.
fn shown(
    info: &ModelInfo,
    along: Option<&str>,
    all: &[EquilibriumRecord],
) -> Columns<'static, EquilibriumRecord> {
    let columns = along.into_iter().fold(Columns::new(), |columns, along| {
        let r = |one: &EquilibriumRecord| one.r.map_or(String::new(), |r| number(r, DIGITS));
        columns.column(along, r)
    });
    let columns = columns
        .each(states(info, ""), state)
        .column(timed(info, "eigenvalues", "1/s"), |one| {
            eigenvalues(&one.eigenvalues)
        })
        .column("stability", |one| {
            one.stability.name().to_owned() + mark(one.artefact)
        });
    if all.iter().any(|one| one.mode.is_some()) {
        columns.column("mode", |one| one.mode.clone().unwrap_or_default())
    } else {
        columns
    }
}

const fn mark(artefact: bool) -> &'static str {
    if artefact { " *" } else { "" }
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

fn special(info: &ModelInfo, along: &str) -> Columns<'static, SpecialEquilibrium> {
    let time = time_unit(info);
    let period = move |one: &SpecialEquilibrium| match one.period {
        Some(period) => number(period, 10) + time,
        None => "-".to_owned(),
    };
    Columns::new()
        .column("special", |one: &SpecialEquilibrium| one.label.clone())
        .column("kind", |one| format!("{}{}", one.kind, mark(one.artefact)))
        .column(along, |one| located(one.r, one.error))
        .column("period", period)
        .column("", |one| one.onset.unwrap_or("").to_owned())
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

/// The first state.
fn picture(info: &ModelInfo, branch: &EquilibriaRecord) -> Figure {
    let first = info.states.first();
    let name = first.map_or("", |state| state.name);
    let y = axis(name, first.and_then(|state| state.unit));
    let mut chart = Chart::new(Panel::new(along_axis(info, &branch.along), y));
    let value = |state: &[f64]| state.first().copied().unwrap_or(0.0);
    let mark = |one: &SpecialEquilibrium| Mark {
        kind: one.kind,
        label: one.label.clone(),
        at: [one.r, value(&one.state)],
        shown: true,
        after: one.after,
    };
    let points = branch.points.iter();
    let points = points.filter_map(|one| {
        let at = [one.r?, value(&one.state)];
        let further = one.beside.as_ref();
        Some(Point {
            at,
            direction: further.map(|(r, state)| [r - at[0], value(state) - at[1]]),
            stability: one.stability,
        })
    });
    chart.add(Drawn {
        points: points.collect(),
        marks: branch.special.iter().map(mark).collect(),
        root: None,
        closed: branch.ended.is_closed(),
    });
    Figure::new("", info.name, String::new()).panel(chart.panel())
}

fn equilibrium<'a>(info: &'a ModelInfo, one: &EquilibriumRecord) -> Document<'a> {
    let document = Document::of(info, one).by_state(&["state"]);
    match &one.set {
        Some(set) => document.put("set", Document::of(info, set).by_state(&["min", "max"])),
        None => document,
    }
}
