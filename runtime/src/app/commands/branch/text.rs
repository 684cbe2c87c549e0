//! A branch as text.

use crate::app::text::{digits, followed, heading, label, number, table, timed};
use crate::model::ModelInfo;
use crate::study::{BranchRecord, Case, OrbitRecord};

pub(super) fn describe(info: &ModelInfo, case: &Case, branch: &BranchRecord) -> String {
    let name = branch.along.name(info);
    let what = format!("a branch of periodic orbits along {name}");
    let mut text = heading(info, case, &what) + &table(&points(info, branch));
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

fn points(info: &ModelInfo, branch: &BranchRecord) -> String {
    let first = info.states.first();
    let largest = first.map(|state| label(&format!("max |{}|", state.name), state.unit));
    let mut lines = format!(
        "{}\t{}\t{}\t|multiplier|\tstability\n",
        followed(info, &branch.along),
        timed(info, "period", "s"),
        largest.unwrap_or_default(),
    );
    lines.extend(branch.points.iter().map(point));
    lines
}

fn point(orbit: &OrbitRecord) -> String {
    let digits = digits(orbit.error_estimate).min(9);
    let shown = |value: Option<f64>| value.map_or(String::new(), |value| number(value, digits));
    let extent = orbit.max_abs.first().copied();
    let [r, period, extent] = [orbit.r, Some(orbit.period), extent].map(shown);
    let multiplier = orbit.floquet.multipliers.first();
    let multiplier = multiplier.map_or(String::new(), |largest| number(largest.norm(), 5));
    let stability = orbit.floquet.stability.name();
    format!("{r}\t{period}\t{extent}\t{multiplier}\t{stability}\n")
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
