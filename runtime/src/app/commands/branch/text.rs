//! A branch as text.

use super::arguments::Shown;
use crate::app::harmonics;
use crate::app::text::{digits, followed, heading, label, line, number, table, timed};
use crate::model::ModelInfo;
use crate::study::{BranchRecord, Case, OrbitRecord};

pub(super) fn describe(
    info: &ModelInfo,
    case: &Case,
    branch: &BranchRecord,
    shown: &Shown,
) -> String {
    let name = branch.along.name(info);
    let what = format!("a branch of periodic orbits along {name}");
    let mut text = heading(info, case, &what) + &table(&points(info, branch, shown));
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

fn points(info: &ModelInfo, branch: &BranchRecord, shown: &Shown) -> String {
    let mut head = vec![followed(info, &branch.along), timed(info, "period", "s")];
    for &j in &shown.states {
        let state = info.states.get(j);
        let name = state.map_or("", |state| state.name);
        head.push(label(
            &format!("max |{name}|"),
            state.and_then(|state| state.unit),
        ));
        let orders = shown.orders.iter();
        head.extend(orders.flat_map(|&order| harmonics::names(info, order, j)));
    }
    head.extend(["|multiplier|", "stability"].map(str::to_owned));
    let lines = branch.points.iter().map(|orbit| point(orbit, shown));
    line(head) + &lines.collect::<String>()
}

fn point(orbit: &OrbitRecord, shown: &Shown) -> String {
    let digits = digits(orbit.error_estimate).min(9);
    let value = |value: Option<f64>| value.map_or(String::new(), |value| number(value, digits));
    let mut row = vec![value(orbit.r), value(Some(orbit.period))];
    for &j in &shown.states {
        row.push(value(orbit.max_abs.get(j).copied()));
        for &order in &shown.orders {
            let known = harmonics::harmonic(orbit, order);
            row.extend(known.map_or_else(Default::default, |one| harmonics::shown(one, j)));
        }
    }
    let multiplier = orbit.floquet.multipliers.first();
    row.push(multiplier.map_or(String::new(), |largest| number(largest.norm(), 5)));
    row.push(orbit.floquet.stability.name().to_owned());
    line(row)
}

/// The special points, if there are any.
fn special(info: &ModelInfo, branch: &BranchRecord) -> String {
    if branch.special.is_empty() {
        return String::new();
    }
    let (name, period) = (followed(info, &branch.along), timed(info, "period", "s"));
    let mut lines = format!("special\tkind\t{name}\t{period}\t\n");
    for point in &branch.special {
        let [r, period] = [point.r, point.period].map(|value| number(value, 10));
        let remark = point.criticality.or(point.note.as_deref()).unwrap_or("");
        lines += &format!("{}\t{}\t{r}\t{period}\t{remark}\n", point.label, point.kind);
    }
    table(&lines)
}
