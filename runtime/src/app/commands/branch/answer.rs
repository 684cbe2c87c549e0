//! A branch, with those that leave it, in all forms.

use crate::app::answer::Answer;
use crate::app::chart::{Chart, Mark, Point, along_axis, axis};
use crate::app::commands::orbit;
use crate::app::document::Document;
use crate::app::request::Request;
use crate::app::spreadsheet::Columns;
use crate::app::text::{digits, followed, heading, label, number, timed};
use crate::field::Work;
use crate::model::ModelInfo;
use crate::report::{Axis, Figure, Panel};
use crate::study::{BranchRecord, Case, OrbitRecord, Special};

/// The tables are those of the branch and of those that leave it: `branch`, `branch-1`, ...
pub(in crate::app::commands) fn answer(
    asked: &Request<'_>,
    branch: &BranchRecord,
) -> Answer<'static> {
    let (info, case) = (asked.info, &asked.case);
    let (text, document) = (describe(info, case, branch), document(info, case, branch));
    let answer = Answer::new("branch", text, document).figure("branch", picture(info, branch));
    let columns = orbit::columns(info, &branch.along);
    let all = branch.all().into_iter().enumerate();
    all.fold(answer, |answer, (number, one)| {
        let name = match number {
            0 => "branch".to_owned(),
            _ => format!("branch-{number}"),
        };
        answer.sheet(name, columns.sheet(&one.points))
    })
}

fn describe(info: &ModelInfo, case: &Case, branch: &BranchRecord) -> String {
    let name = branch.along.name(info);
    let what = format!("a branch of periodic orbits along {name}");
    let mut text = heading(info, case, &what) + &shown(info, branch).text(&branch.points);
    if !branch.special.is_empty() {
        text += &format!("\n{}", special(info, branch));
    }
    for (i, below) in branch.all().into_iter().enumerate().skip(1) {
        let from = below.from.as_deref().unwrap_or("another");
        let period = below.points.first().map_or(0, |point| point.period_count);
        let (count, ended) = (below.points.len(), below.ended.word());
        text += &format!(
            "\nbranch {i}, period {period}, leaves its parent at {from}; {count} points, ended: {ended}\n{}",
            special(info, below)
        );
    }
    text
}

/// What is shown of its orbits.
fn shown(info: &ModelInfo, branch: &BranchRecord) -> Columns<'static, OrbitRecord> {
    let first = info.states.first();
    let largest = first.map(|state| label(&format!("max |{}|", state.name), state.unit));
    let shown = |orbit: &OrbitRecord, value: Option<f64>| {
        let digits = digits(orbit.error_estimate).min(9);
        value.map_or(String::new(), |value| number(value, digits))
    };
    let multiplier = |orbit: &OrbitRecord| {
        let largest = orbit.floquet.multipliers.first();
        largest.map_or(String::new(), |largest| number(largest.norm(), 5))
    };
    Columns::new()
        .column(followed(info, &branch.along), move |orbit: &OrbitRecord| {
            shown(orbit, orbit.r)
        })
        .column(timed(info, "period", "s"), move |orbit| {
            shown(orbit, Some(orbit.period))
        })
        .column(largest.unwrap_or_default(), move |orbit| {
            shown(orbit, orbit.max_abs.first().copied())
        })
        .column("|multiplier|", multiplier)
        .column("stability", |orbit| {
            orbit.floquet.stability.name().to_owned()
        })
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
        .column(followed(info, &branch.along), |one| number(one.r, 10))
        .column(timed(info, "period", "s"), |one| number(one.period, 10))
        .column("", remark)
        .text(&branch.special)
}

/// The extent of the first state, and the period.
fn picture(info: &ModelInfo, branch: &BranchRecord) -> Figure {
    let parameter = along_axis(info, &branch.along);
    let first = info.states.first();
    let name = format!("max |{}|", first.map_or("", |state| state.name));
    let extent = axis(&name, first.and_then(|state| state.unit));
    let period = Axis::new(&timed(info, "period", "s"));
    let mut extents = Chart::new(Panel::new(parameter.clone(), extent));
    let mut periods = Chart::new(Panel::new(parameter, period));
    let largest = |values: &[f64]| values.first().copied().unwrap_or(0.0);
    for one in branch.all() {
        extents.add(
            &points(one, |orbit| largest(&orbit.max_abs)),
            marks(one, |special| largest(&special.max_abs)),
        );
        periods.add(
            &points(one, |orbit| orbit.period),
            marks(one, |special| special.period),
        );
    }
    Figure::new("", info.name, String::new())
        .columns(2)
        .panel(extents.panel())
        .panel(periods.panel())
}

fn points(branch: &BranchRecord, shown: impl Fn(&OrbitRecord) -> f64) -> Vec<Point> {
    let point = |orbit: &OrbitRecord| {
        Some(Point {
            at: [orbit.r?, shown(orbit)],
            stability: orbit.floquet.stability,
        })
    };
    branch.points.iter().filter_map(point).collect()
}

fn marks(branch: &BranchRecord, shown: impl Fn(&Special) -> f64) -> Vec<Mark> {
    let mark = |special: &Special| Mark {
        kind: special.kind,
        label: special.label.clone(),
        at: [special.r, shown(special)],
        after: special.after,
    };
    branch.special.iter().map(mark).collect()
}

/// A branch with those that leave it.
fn document<'a>(info: &'a ModelInfo, case: &Case, branch: &BranchRecord) -> Document<'a> {
    let orbit = |point: &OrbitRecord| orbit::document(info, point).put("work", point.work);
    let mut work = Work::default();
    branch.points.iter().for_each(|point| work += point.work);
    Document::case(info, case)
        .range("along", &branch.along)
        .maybe("from", branch.from.as_ref())
        .list("points", &branch.points, orbit)
        .put("special", &branch.special)
        .ended(&branch.ended)
        .maybe("began", branch.began.as_ref().map(|ended| ended.word()))
        .list("branches", &branch.branches, |below| {
            document(info, case, below)
        })
        .units()
        .put("work", work)
}
