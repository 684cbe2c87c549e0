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

/// What its points are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Of {
    Orbits,
    Equilibria,
}

/// A curve without the branch from which it starts.
pub(super) fn answer<'a, B>(
    info: &'a ModelInfo,
    case: &'a Case,
    curve: &'a CurveRecord<B>,
    of: Of,
) -> Answer<'a> {
    Answer::new(
        "curve",
        || describe(info, case, curve),
        || document(info, case, curve),
    )
    .figure("curve", || picture(info, curve))
    .sheet("curve", move || {
        columns(info, [&curve.along, &curve.and], of).sheet(&curve.points)
    })
}

/// The columns of its points.
pub(super) fn columns(
    info: &ModelInfo,
    ranges: [&Along; 2],
    of: Of,
) -> Columns<'static, CurvePointRecord> {
    let [p, q] = ranges.map(|range| followed(info, range));
    let columns = Columns::new()
        .number(p, |point: &CurvePointRecord| point.p)
        .number(q, |point| point.q)
        .number(timed(info, "period", "s"), |point| point.period)
        .numbers(states(info, ""), |point, j| point.state.get(j).copied());
    let order = info.states.len();
    let columns = match of {
        Of::Orbits => {
            let heads = parts("multiplier", order.saturating_sub(1), &["re", "im"]);
            columns.numbers(heads, |point, j| part(&point.multipliers, j))
        }
        Of::Equilibria => {
            let heads = parts("eigenvalue", order, &["re", "im"]);
            let heads = heads.iter().map(|head| timed(info, head, "1/s"));
            let columns = columns.numbers(heads, |point, j| part(&point.eigenvalues, j));
            let columns = columns.number("l1", |point| point.l1);
            columns.column("onset", |point| point.onset.unwrap_or(""))
        }
    };
    columns
        .number("residual", |point| point.residual)
        .number("test", |point| point.test)
}

fn describe<B>(info: &ModelInfo, case: &Case, curve: &CurveRecord<B>) -> String {
    let ranges = [&curve.along, &curve.and];
    let [p, q] = ranges.map(|range| followed(info, range));
    let names = ranges.map(|range| range.name(info)).join(" and ");
    let what = format!("{} points ({}) in {names}", curve.kind, curve.of);
    let shown = |value: f64| number(value, 10);
    let mut points = Columns::new()
        .column(&*p, |point: &CurvePointRecord| shown(point.p))
        .column(&*q, |point| shown(point.q));
    if curve.points.iter().any(|point| point.period.is_some()) {
        let period = |point: &CurvePointRecord| point.period.map_or(String::new(), shown);
        points = points.column(timed(info, "period", "s"), period);
    }
    if curve.points.iter().any(|point| point.onset.is_some()) {
        points = points.column("onset", |point| point.onset.unwrap_or(""));
    }
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
fn picture<B>(info: &ModelInfo, curve: &CurveRecord<B>) -> Figure {
    let [p, q] = [&curve.along, &curve.and].map(|range| along_axis(info, range));
    let name = curve.kind.name();
    let places = curve.points.iter().map(|one| [one.q, one.p]);
    let plane = Panel::new(q.clone(), p).curve(Curve::smooth(name, 0, places.collect()));
    let plane = plane.curves(special_points(curve.special.iter().map(|one| Mark {
        kind: one.kind,
        label: one.label.clone(),
        after: 0,
        at: [one.point.q, one.point.p],
        shown: true,
    })));
    let figure = Figure::new("", info.name, String::new()).panel(plane);
    let periods = curve.points.iter();
    let periods: Vec<[f64; 2]> = periods
        .filter_map(|one| Some([one.q, one.period?]))
        .collect();
    if periods.is_empty() {
        return figure;
    }
    let period = Panel::new(q, Axis::new(&timed(info, "period", "s")));
    figure
        .columns(2)
        .panel(period.curve(Curve::smooth(name, 0, periods)))
}

fn document<'a, B>(info: &'a ModelInfo, case: &Case, curve: &CurveRecord<B>) -> Document<'a> {
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
