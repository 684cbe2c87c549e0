//! A branch, with those that leave it, in all forms.

use crate::app::chart::{Chart, Mark, along_axis, axis};
use crate::app::commands::orbit;
use crate::app::document::Document;
use crate::app::output::Answer;
use crate::app::request::Request;
use crate::app::spreadsheet::Columns;
use crate::app::text::{followed, heading, number, timed};
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
    let mut text =
        heading(info, case, &what) + &orbit::shown(info, &branch.along).text(&branch.points);
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
        draw(
            &mut extents,
            one,
            |orbit| largest(&orbit.max_abs),
            |special| largest(&special.max_abs),
        );
        draw(
            &mut periods,
            one,
            |orbit| orbit.period,
            |special| special.period,
        );
    }
    Figure::new("", info.name, String::new())
        .columns(2)
        .panel(extents.panel())
        .panel(periods.panel())
}

/// Draws a quantity of the orbits of a branch, and of its special points.
fn draw(
    chart: &mut Chart,
    branch: &BranchRecord,
    of: impl Fn(&OrbitRecord) -> f64,
    special: impl Fn(&Special) -> f64,
) {
    let points = branch.points.iter();
    let points = points.filter_map(|one| Some(([one.r?, of(one)], one.floquet.stability)));
    let mark = |one: &Special| Mark {
        kind: one.kind,
        label: one.label.clone(),
        after: one.after,
        at: [one.r, special(one)],
    };
    chart.add(points.collect(), branch.special.iter().map(mark).collect());
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
