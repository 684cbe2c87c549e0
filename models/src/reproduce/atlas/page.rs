//! The interactive page: its data, and the page around them.

use serde_json::{Value, json};
use stickslip::bifurcation::Stability;
use stickslip::report::Page;
use stickslip::study::{BranchRecord, Dynamics, OrbitRecord, Special, parallel};

use super::super::ask::Subject;
use super::Atlas;
use super::named::matches;

const TEMPLATE: &str = include_str!("page.html");
/// Accuracy of the motions that are drawn.
const DRAWN: f64 = 1e-6;
/// Points of a drawn motion for each crossing of the section.
const POINTS: usize = 32;
/// Orbits whose speed of the belt, frequency and displacement differ by less than this from the last one are left out.
const THIN: f64 = 2e-3;

/// The page of all branches.
pub(super) fn page(pair: &Subject, smoothed: &Atlas, exact: &Atlas) -> Page {
    let named = matches(smoothed, exact);
    let marked: [Vec<&Special>; 2] = [
        named.iter().filter_map(|found| found.smoothed).collect(),
        named.iter().filter_map(|found| found.exact).collect(),
    ];
    let atlases = [smoothed, exact];
    let systems = atlases.iter().zip(&marked);
    let systems: Value = systems
        .map(|(atlas, marked)| system(pair, atlas, marked))
        .collect();
    Page {
        name: "atlas".to_owned(),
        link: "All branches, to be explored: Figs. 3.15 to 3.18, smoothed and exact".to_owned(),
        html: TEMPLATE.replace("/*DATA*/", &systems.to_string()),
        data: (
            HEAD.map(str::to_owned).to_vec(),
            atlases.iter().flat_map(|atlas| rows(atlas)).collect(),
        ),
    }
}

const HEAD: [&str; 15] = [
    "system",
    "branch",
    "family",
    "n",
    "V_dr",
    "period",
    "max_abs_X1",
    "stability",
    "multiplier_1_re",
    "multiplier_1_im",
    "multiplier_2_re",
    "multiplier_2_im",
    "multiplier_3_re",
    "multiplier_3_im",
    "word",
];

fn rows(atlas: &Atlas) -> Vec<Vec<String>> {
    let all = atlas.branches().enumerate();
    all.flat_map(|(number, (family, branch))| {
        branch.points.iter().map(move |point| {
            let multipliers = |i: usize| point.floquet.multipliers.get(i);
            let parts = (0..3).flat_map(|i| match multipliers(i) {
                Some(one) => [one.re, one.im].map(|part| part.to_string()),
                None => [String::new(), String::new()],
            });
            let mut row = vec![
                atlas.dynamics.to_string(),
                number.to_string(),
                family.to_owned(),
                point.period_count.to_string(),
                point.r.unwrap_or(f64::NAN).to_string(),
                point.period.to_string(),
                point.max_abs[0].to_string(),
                point.floquet.stability.name().to_owned(),
            ];
            row.extend(parts);
            row.push(point.word.clone().unwrap_or_default());
            row
        })
    })
    .collect()
}

fn system(pair: &Subject, atlas: &Atlas, marked: &[&Special]) -> Value {
    let all: Vec<(&str, &BranchRecord)> = atlas.branches().collect();
    let name = match atlas.dynamics {
        Dynamics::Exact => "exact".to_owned(),
        other => format!("smoothed by {}", other.to_string().replace(':', ", ε = ")),
    };
    json!({ "name": name, "branches": parallel(&all, |leaf| branch(pair, leaf, marked)) })
}

fn branch(pair: &Subject, (family, branch): &(&str, &BranchRecord), marked: &[&Special]) -> Value {
    let kept = thinned(&branch.points);
    let points = kept.iter().map(|(_, orbit)| point(pair, orbit));
    let after = |one: &Special| kept.iter().filter(|(i, _)| *i < one.after).count();
    let special = branch.special.iter().map(|one| {
        let named = marked.iter().any(|mark| std::ptr::eq(*mark, one));
        special(one, named, after(one))
    });
    json!({
        "family": family, "from": branch.from, "ended": branch.ended.word(),
        "origin": branch.root.as_ref().map(|root| self::special(root, false, 0)),
        "points": points.collect::<Vec<_>>(), "special": special.collect::<Vec<_>>(),
    })
}

/// Enough of these orbits to draw their branch, with their numbers.
fn thinned(points: &[OrbitRecord]) -> Vec<(usize, &OrbitRecord)> {
    let mut kept: Vec<(usize, &OrbitRecord)> = Vec::new();
    for (i, point) in points.iter().enumerate() {
        let far = |(_, last): &(usize, &OrbitRecord)| {
            let apart = (point.r.unwrap_or(0.0) - last.r.unwrap_or(0.0)).abs()
                + (1.0 / point.period - 1.0 / last.period).abs()
                + 0.2 * (point.max_abs[0] - last.max_abs[0]).abs();
            let period_count = point.period_count.max(1) as f64;
            apart * period_count.sqrt() > THIN || point.floquet.stability != last.floquet.stability
        };
        if i + 1 == points.len() || kept.last().is_none_or(far) {
            kept.push((i, point));
        }
    }
    kept
}

fn point(pair: &Subject, orbit: &OrbitRecord) -> Value {
    let multipliers = orbit.floquet.multipliers.iter();
    let section = orbit.section.iter().filter_map(|state| state.first());
    let mut point = json!({
        "r": digits(orbit.r.unwrap_or(0.0), 8), "T": digits(orbit.period, 8),
        "m": digits(orbit.max_abs[0], 7), "n": orbit.period_count,
        "s": u8::from(orbit.floquet.stability == Stability::Stable),
        "mu": list(multipliers.flat_map(|mu| [mu.re, mu.im]), 5), "p": list(section.copied(), 4),
    });
    if let Some(further) = orbit.further() {
        let along = |of: fn(&OrbitRecord) -> f64| of(&further) - of(orbit);
        let way = [
            along(|orbit| orbit.r.unwrap_or(f64::NAN)),
            along(|orbit| orbit.period),
            along(|orbit| orbit.max_abs[0]),
        ];
        let longest = way.iter().fold(0.0_f64, |most, part| most.max(part.abs()));
        point["d"] = list(way.map(|part| part / longest).into_iter(), 4).into();
    }
    if let Some(word) = &orbit.word {
        point["w"] = word.as_str().into();
    }
    if let Some(path) = path(pair, orbit) {
        point["x"] = list(path.into_iter(), 3).into();
    }
    point
}

/// Both displacements along one period, one after the other.
fn path(pair: &Subject, orbit: &OrbitRecord) -> Option<Vec<f64>> {
    let motion = pair.motion(orbit, DRAWN).ok()?;
    let wanted = POINTS * orbit.period_count.min(16);
    let mut path = Vec::with_capacity(2 * wanted + 2);
    let mut after = f64::NEG_INFINITY;
    let gap = orbit.period / wanted as f64;
    let last = motion.times.len().saturating_sub(1);
    for (i, (time, state)) in motion.times.iter().zip(&motion.states).enumerate() {
        if time - after >= gap || i == last {
            path.extend([state[0], state[2]]);
            after = *time;
        }
    }
    Some(path)
}

fn special(special: &Special, named: bool, after: usize) -> Value {
    json!({
        "named": named, "a": after, "k": special.kind.name(), "l": special.label,
        "r": digits(special.r, 9), "T": digits(special.turns as f64 * special.period, 8),
        "m": digits(special.max_abs[0], 7), "c": special.criticality,
    })
}

fn list(values: impl Iterator<Item = f64>, count: usize) -> Vec<Option<f64>> {
    values.map(|value| digits(value, count)).collect()
}

/// A number with so many significant digits at most, if it is one.
fn digits(value: f64, count: usize) -> Option<f64> {
    let rounded: f64 = format!("{value:.*e}", count.max(1) - 1).parse().ok()?;
    let tiny = rounded.abs() < 1e-12;
    rounded
        .is_finite()
        .then_some(if tiny { 0.0 } else { rounded })
}
