//! A curve as text.

use crate::app::text::{followed, heading, number, table, timed, work};
use crate::model::ModelInfo;
use crate::study::{Case, CurveRecord};

pub(super) fn describe(info: &ModelInfo, case: &Case, curve: &CurveRecord) -> String {
    let ranges = [&curve.along, &curve.and];
    let [p, q] = ranges.map(|range| followed(info, range));
    let names = ranges.map(|range| range.name(info)).join(" and ");
    let shown = |value: f64| number(value, 10);
    let what = format!("{} points ({}) in {names}", curve.kind, curve.of);
    let mut points = format!("{p}\t{q}\t{}\n", timed(info, "period", "s"));
    for point in &curve.points {
        let [p, q, period] = [point.p, point.q, point.period].map(shown);
        points += &format!("{p}\t{q}\t{period}\n");
    }
    let mut text = heading(info, case, &what) + &table(&points);
    if !curve.special.is_empty() {
        let mut special = format!("special\tkind\t{p}\t{q}\n");
        for one in &curve.special {
            let [p, q] = [one.point.p, one.point.q].map(shown);
            special += &format!("{}\t{}\t{p}\t{q}\n", one.label, one.kind);
        }
        text += &format!("\n{}", table(&special));
    }
    text + &format!("\n  {}\n", work(&curve.work))
}
