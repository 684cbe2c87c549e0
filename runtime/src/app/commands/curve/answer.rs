//! A curve in all forms.

use crate::app::answer::Answer;
use crate::app::axis::along_axis;
use crate::app::document::{Document, named};
use crate::app::spreadsheet::{Columns, part, parts};
use crate::app::text::{followed, heading, number, states, timed, work};
use crate::model::ModelInfo;
use crate::report::chart::{Mark, special_points};
use crate::report::{Axis, Curve, Figure, Panel};
use crate::study::{Along, Case, CurvePointRecord, CurveRecord, SpecialCurvePoint};

/// A curve without the branch from which it starts.
pub(super) fn answer<'a>(
    info: &'a ModelInfo,
    case: &'a Case,
    curve: &'a CurveRecord,
) -> Answer<'a> {
    Answer::new(
        "curve",
        || describe(info, case, curve),
        || document(info, case, curve),
    )
    .figure("curve", || picture(info, curve))
    .sheet("curve", || {
        columns(info, [&curve.along, &curve.and]).sheet(&curve.points)
    })
}

/// The columns of its points.
pub(super) fn columns(info: &ModelInfo, ranges: [&Along; 2]) -> Columns<'static, CurvePointRecord> {
    let [p, q] = ranges.map(|range| followed(info, range));
    let multipliers = parts(
        "multiplier",
        info.states.len().saturating_sub(1),
        &["re", "im"],
    );
    Columns::new()
        .number(p, |point: &CurvePointRecord| point.p)
        .number(q, |point| point.q)
        .number(timed(info, "period", "s"), |point| point.period)
        .numbers(states(info, ""), |point, j| point.state.get(j).copied())
        .numbers(multipliers, |point, j| part(&point.multipliers, j))
        .number("residual", |point| point.residual)
        .number("test", |point| point.test)
}

fn describe(info: &ModelInfo, case: &Case, curve: &CurveRecord) -> String {
    let ranges = [&curve.along, &curve.and];
    let [p, q] = ranges.map(|range| followed(info, range));
    let names = ranges.map(|range| range.name(info)).join(" and ");
    let what = format!("{} points ({}) in {names}", curve.kind, curve.of);
    let shown = |value: f64| number(value, 10);
    let points = Columns::new()
        .column(&*p, |point: &CurvePointRecord| shown(point.p))
        .column(&*q, |point| shown(point.q))
        .column(timed(info, "period", "s"), |point| shown(point.period));
    let special = Columns::new()
        .column("special", |one: &SpecialCurvePoint| one.label.clone())
        .column("kind", |one| match &one.branches {
            Some(branches) => format!("{} along {}", one.kind, branches.name(info)),
            None => one.kind.to_string(),
        })
        .column(&*p, |one| shown(one.point.p))
        .column(&*q, |one| shown(one.point.q));
    let mut text = heading(info, case, &what) + &points.text(&curve.points);
    if !curve.special.is_empty() {
        text += &format!("\n{}", special.text(&curve.special));
    }
    text + &format!("\n  {}\n", work(&curve.work))
}

/// The curve with its special points, and the period along it.
fn picture(info: &ModelInfo, curve: &CurveRecord) -> Figure {
    let [p, q] = [&curve.along, &curve.and].map(|range| along_axis(info, range));
    let name = curve.kind.name();
    let places = curve.points.iter().map(|one| [one.q, one.p]);
    let periods = curve.points.iter().map(|one| [one.q, one.period]);
    let period = Curve::smooth(name, 0, periods.collect());
    let plane = Panel::new(q.clone(), p).curve(Curve::smooth(name, 0, places.collect()));
    let plane = plane.curves(special_points(curve.special.iter().map(|one| Mark {
        kind: one.kind,
        label: one.label.clone(),
        after: 0,
        at: [one.point.q, one.point.p],
        shown: true,
    })));
    Figure::new("", info.name, String::new())
        .columns(2)
        .panel(plane)
        .panel(Panel::new(q, Axis::new(&timed(info, "period", "s"))).curve(period))
}

fn document<'a>(info: &'a ModelInfo, case: &Case, curve: &CurveRecord) -> Document<'a> {
    let names = [&curve.along, &curve.and].map(|range| range.name(info));
    let add = |document: Document<'a>, point: &CurvePointRecord| {
        let at = named(names.into_iter(), [point.p, point.q]);
        document.put("at", at).all(point).by_state(&["state"])
    };
    let special = |one: &SpecialCurvePoint| {
        let head = Document::new(info)
            .put("kind", one.kind)
            .put("label", &one.label)
            .maybe("branches_along", one.branches.map(|along| along.name(info)));
        add(head, &one.point)
    };
    Document::case(info, case)
        .range("along", &curve.along)
        .range("and", &curve.and)
        .put("of", &curve.of)
        .put("kind", curve.kind)
        .list("points", &curve.points, |point| {
            add(Document::new(info), point)
        })
        .list("special", &curve.special, special)
        .ended(&curve.ended)
        .units()
        .put("work", curve.work)
}
