//! A branch, with those that leave it, in all forms.

use std::f64::consts::TAU;
use std::rc::Rc;

use crate::app::answer::Answer;
use crate::app::axis::{along_axis, axis, headed_axis};
use crate::app::commands::orbit;
use crate::app::document::Document;
use crate::app::harmonics::{harmonic, names};
use crate::app::request::Request;
use crate::app::spreadsheet::Columns;
use crate::app::text::{certain, followed, heading, located, number, timed};
use crate::field::Work;
use crate::model::ModelInfo;
use crate::report::chart::{Chart, Drawn};
use crate::report::{Axis, Figure, Panel};
use crate::study::{Along, BranchRecord, Case, OrbitRecord, Special};

/// The tables are those of the branch and of those that leave it: `branch`, `branch-1`, ...; text and picture show these
/// states.
pub(in crate::app::commands) fn answer<'a>(
    asked: &'a Request<'_>,
    branch: &'a BranchRecord,
    shown: &'a [usize],
) -> Answer<'a> {
    let (info, case) = (asked.info, &asked.case);
    let answer = Answer::new(
        "branch",
        || describe(asked, branch, shown),
        || document(info, case, branch),
    )
    .figure("branch", || picture(asked, branch, shown));
    let columns = Rc::new(orbit::columns(info, &branch.along, &case.harmonics));
    let all = branch.all().into_iter().enumerate();
    all.fold(answer, |answer, (number, one)| {
        let name = match number {
            0 => "branch".to_owned(),
            _ => format!("branch-{number}"),
        };
        let columns = columns.clone();
        answer.sheet(name, move || columns.sheet(&one.points))
    })
}

fn describe(asked: &Request<'_>, branch: &BranchRecord, states: &[usize]) -> String {
    let info = asked.info;
    let name = branch.along.name(info);
    let what = format!("a branch of periodic orbits along {name}");
    let points = orbit::shown(asked, &branch.along, states).text(&branch.points);
    let mut text = heading(info, &asked.case, &what) + &points;
    if !branch.special.is_empty() {
        text += &format!("\n{}", special(info, branch));
    }
    for (i, below) in branch.all().into_iter().enumerate().skip(1) {
        let from = below.from.as_deref().unwrap_or("another");
        let period = below.points.first().map_or(0, |point| point.period_count);
        let (count, reason) = (below.points.len(), &below.ended.reason);
        text += &format!(
            "\nbranch {i}, period {period}, leaves its parent at {from}; {count} points; {reason}\n{}",
            special(info, below)
        );
    }
    text
}

/// The special points, if there are any.
fn special(info: &ModelInfo, branch: &BranchRecord) -> String {
    if branch.special.is_empty() {
        return String::new();
    }
    let remark = |one: &Special| {
        one.criticality
            .or(one.note.as_deref())
            .unwrap_or("")
            .to_owned()
    };
    Columns::new()
        .column("special", |one: &Special| one.label.clone())
        .column("kind", |one| one.kind.to_string())
        .column(followed(info, &branch.along), |one| {
            located(one.r, one.error)
        })
        .column(timed(info, "period", "s"), |one| {
            // It is known less well than what it was located in, and at a fold much less.
            let digits = certain(one.r, one.error).max(5) - 1;
            number(
                one.period,
                digits.min(certain(one.period, one.period_error)),
            )
        })
        .column("", remark)
        .text(&branch.special)
}

/// The extent of the states that are shown, and the period; amplitudes and phases, each pair in a row.
fn picture(asked: &Request<'_>, branch: &BranchRecord, states: &[usize]) -> Figure {
    let info = asked.info;
    let extents = states.iter().map(|&j| extent(info, branch, j));
    let mut panels: Vec<Panel> = extents.collect();
    let odd = panels.len() % 2 == 1;
    if odd {
        panels.push(period(info, branch));
    }
    for &j in states {
        let orders = asked.case.harmonics.iter();
        panels.extend(orders.flat_map(|&order| response(info, branch, order, j)));
    }
    if !odd {
        panels.push(period(info, branch));
    }
    let figure = Figure::new("", info.name, String::new()).columns(2);
    panels.into_iter().fold(figure, Figure::panel)
}

fn period(info: &ModelInfo, branch: &BranchRecord) -> Panel {
    let period = Axis::new(&timed(info, "period", "s"));
    let mut periods = Chart::new(Panel::new(along_axis(info, &branch.along), period));
    for one in branch.all().into_iter().enumerate() {
        let special = |special: &Special| special.turns as f64 * special.period;
        periods.add(Drawn::of(one, |orbit| Some(orbit.period), special));
    }
    periods.panel()
}

fn extent(info: &ModelInfo, branch: &BranchRecord, j: usize) -> Panel {
    extents(info, &branch.along, branch.all().into_iter().enumerate(), j)
}

/// The largest magnitude of a state along numbered branches.
pub(in crate::app::commands) fn extents<'a>(
    info: &ModelInfo,
    along: &Along,
    branches: impl Iterator<Item = (usize, &'a BranchRecord)>,
    j: usize,
) -> Panel {
    let (name, unit) = orbit::largest(info, j);
    let mut extents = Chart::new(Panel::new(along_axis(info, along), axis(&name, unit)));
    for one in branches {
        let special = |special: &Special| special.max_abs.get(j).copied().unwrap_or(f64::NAN);
        extents.add(Drawn::of(
            one,
            |orbit| orbit.max_abs.get(j).copied(),
            special,
        ));
    }
    extents.panel()
}

/// Amplitude and phase of a state at a harmonic.
fn response(info: &ModelInfo, branch: &BranchRecord, order: usize, j: usize) -> [Panel; 2] {
    let [mut amplitudes, mut phases] = names(info, order, j).map(|name| {
        Chart::new(Panel::new(
            along_axis(info, &branch.along),
            headed_axis(&name),
        ))
    });
    for one in branch.all().into_iter().enumerate() {
        let amplitude = |orbit: &OrbitRecord| Some(harmonic(orbit, order)?.amplitude[j]);
        let mut before = None;
        let phase = |orbit: &OrbitRecord| {
            let known = harmonic(orbit, order)?;
            let certain = known.amplitude[j] > known.error[j];
            let next = certain.then(|| unwrapped(known.phase[j], before))?;
            before = Some(next);
            before
        };
        let nowhere = |_: &Special| f64::NAN;
        amplitudes.add(Drawn::of(one, amplitude, nowhere));
        phases.add(Drawn::of(one, phase, nowhere));
    }
    [amplitudes.panel(), phases.panel()]
}

/// A phase, so many turns away that it goes on from the one before.
fn unwrapped(phase: f64, before: Option<f64>) -> f64 {
    let before = before.unwrap_or(phase);
    phase + ((before - phase) / TAU).round() * TAU
}

/// A branch with those that leave it, under what holds for all of them.
fn document<'a>(info: &'a ModelInfo, case: &Case, branch: &BranchRecord) -> Document<'a> {
    Document::case(info, case)
        .range("along", &branch.along)
        .units()
        .all(&found(info, branch))
}

/// A branch with those that leave it.
pub(in crate::app::commands) fn found<'a>(
    info: &'a ModelInfo,
    branch: &BranchRecord,
) -> Document<'a> {
    let orbit = |point: &OrbitRecord| orbit::point(info, point).put("work", point.work);
    let mut work = Work::default();
    branch.points.iter().for_each(|point| work += point.work);
    Document::new(info)
        .maybe("from", branch.from.as_ref())
        .list("points", &branch.points, orbit)
        .list("special", &branch.special, |one| {
            let document = Document::of(info, one).by_state(&["state"]);
            document.modes(&one.modes)
        })
        .ended(&branch.ended)
        .maybe("began", branch.began.as_ref().map(|ended| ended.word()))
        .list("branches", &branch.branches, |below| found(info, below))
        .put("work", work)
}
