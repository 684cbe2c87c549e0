//! A branch as text.

use crate::app::text::{digits, followed, label, number, parameters, table, timed};
use crate::model::ModelInfo;
use crate::study::{BranchRecord, Case, OrbitRecord};

pub(super) fn describe(info: &ModelInfo, case: &Case, branch: &BranchRecord) -> String {
    let name = branch.along.name(info);
    let mut text = format!(
        "{}, {}: a branch of periodic orbits along {name}\n",
        info.command, case.dynamics
    );
    text.push_str(&format!("  {}\n\n", parameters(info, case)));
    text.push_str(&table(&points(info, branch)));
    if !branch.special.is_empty() {
        text.push_str(&format!("\n{}", table(&special(info, branch))));
    }
    for (i, below) in branch.all().into_iter().enumerate().skip(1) {
        let from = below.from.as_deref().unwrap_or("another");
        let count = below.points.first().map_or(0, |point| point.period_count);
        text.push_str(&format!(
            "\nbranch {i}, period {count}, leaves its parent at {from}; {} points, ended: {}\n",
            below.points.len(),
            below.ended.word
        ));
        if !below.special.is_empty() {
            text.push_str(&table(&special(info, below)));
        }
    }
    text
}

fn points(info: &ModelInfo, branch: &BranchRecord) -> Vec<Vec<String>> {
    let largest = info.states.first().map_or(String::new(), |state| {
        label(&format!("max |{}|", state.name), state.unit)
    });
    let head = [
        followed(info, &branch.along),
        timed(info, "period", "s"),
        largest,
        "|multiplier|".to_owned(),
        "stability".to_owned(),
    ];
    let mut rows = vec![head.to_vec()];
    rows.extend(branch.points.iter().map(point));
    rows
}

fn point(orbit: &OrbitRecord) -> Vec<String> {
    let digits = digits(orbit.error_estimate).min(9);
    let largest = orbit.floquet.multipliers.first();
    vec![
        orbit.r.map_or(String::new(), |r| number(r, digits)),
        number(orbit.period, digits),
        orbit
            .max_abs
            .first()
            .map_or(String::new(), |&value| number(value, digits)),
        largest.map_or(String::new(), |multiplier| number(multiplier.norm(), 5)),
        orbit.floquet.stability.name().to_owned(),
    ]
}

fn special(info: &ModelInfo, branch: &BranchRecord) -> Vec<Vec<String>> {
    let (name, period) = (followed(info, &branch.along), timed(info, "period", "s"));
    let mut rows = vec![
        ["special", "kind", &name, &period, ""]
            .map(str::to_owned)
            .to_vec(),
    ];
    rows.extend(branch.special.iter().map(|point| {
        vec![
            point.label.clone(),
            point.kind.to_owned(),
            number(point.r, 10),
            number(point.period, 10),
            point
                .criticality
                .or(point.note.as_deref())
                .unwrap_or("")
                .to_owned(),
        ]
    }));
    rows
}
