//! A curve as text.

use crate::app::text::{followed, number, parameters, table, timed, work};
use crate::model::ModelInfo;
use crate::study::{Case, CurveRecord};

const DIGITS: usize = 10;

pub(super) fn describe(info: &ModelInfo, case: &Case, curve: &CurveRecord) -> String {
    let names = [&curve.along, &curve.and].map(|range| range.name(info));
    let mut text = format!(
        "{}, {}: {} points ({}) in {} and {}\n  {}\n\n",
        info.command,
        case.dynamics,
        curve.kind,
        curve.of,
        names[0],
        names[1],
        parameters(info, case)
    );
    let axes = || [&curve.along, &curve.and].map(|range| followed(info, range));
    let mut rows = vec![[axes().to_vec(), vec![timed(info, "period", "s")]].concat()];
    rows.extend(curve.points.iter().map(|point| {
        let values = [point.p, point.q, point.period];
        values.map(|value| number(value, DIGITS)).to_vec()
    }));
    text.push_str(&table(&rows));
    if !curve.special.is_empty() {
        let [p, q] = axes();
        let mut rows = vec![vec!["special".to_owned(), "kind".to_owned(), p, q]];
        rows.extend(curve.special.iter().map(|one| {
            let place = [one.point.p, one.point.q].map(|value| number(value, DIGITS));
            let words = [one.label.clone(), one.kind.to_owned()];
            words.into_iter().chain(place).collect()
        }));
        text.push_str(&format!("\n{}", table(&rows)));
    }
    text.push_str(&format!("\n  {}\n", work(&curve.work)));
    text
}
