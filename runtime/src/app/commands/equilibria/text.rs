//! Equilibria as text.

use nalgebra::Complex;

use crate::app::text::{followed, heading, line, number, states, table, time_unit, timed};
use crate::model::ModelInfo;
use crate::study::{Case, EquilibriaRecord, EquilibriumRecord};

const DIGITS: usize = 9;

/// A list of equilibria.
pub(super) fn list(info: &ModelInfo, case: &Case, found: &[EquilibriumRecord]) -> String {
    heading(info, case, "equilibria")
        + &table(&rows(info, None, found))
        + &remarks(case, found.iter().any(|one| one.artefact), false)
}

/// A branch of equilibria.
pub(super) fn describe(info: &ModelInfo, case: &Case, branch: &EquilibriaRecord) -> String {
    let (name, along) = (branch.along.name(info), followed(info, &branch.along));
    let mut text = heading(info, case, &format!("a branch of equilibria along {name}"));
    text += &table(&rows(info, Some(&along), &branch.points));
    if !branch.special.is_empty() {
        text += &format!("\n{}", table(&special(info, &along, branch)));
    }
    let points = branch.points.iter().any(|point| point.artefact);
    let special = branch.special.iter().any(|point| point.artefact);
    text + &remarks(case, points, special)
}

fn rows(info: &ModelInfo, name: Option<&str>, all: &[EquilibriumRecord]) -> String {
    let rest = [timed(info, "eigenvalues", "1/s"), "stability".to_owned()];
    let modes = all.iter().any(|one| one.mode.is_some());
    let mode = modes.then(|| "mode".to_owned());
    let name = name.map(str::to_owned).into_iter();
    let mut lines = line(name.chain(states(info, "")).chain(rest).chain(mode));
    for one in all {
        let r = one.r.map(|r| number(r, DIGITS)).into_iter();
        let states = (0..info.states.len()).map(|j| state(one, j));
        let stability = format!("{}{}", one.stability.name(), mark(one.artefact));
        let rest = [eigenvalues(&one.eigenvalues), stability];
        lines += &line(r.chain(states).chain(rest).chain(one.mode.clone()));
    }
    lines
}

const fn mark(artefact: bool) -> &'static str {
    if artefact { " *" } else { "" }
}

/// A state, or the interval that it covers in a set.
fn state(one: &EquilibriumRecord, j: usize) -> String {
    let at = |values: &[f64]| values.get(j).map_or(String::new(), |&value| rounded(value));
    match &one.set {
        Some(set) if at(&set.low) != at(&set.high) => {
            format!("[{}, {}]", at(&set.low), at(&set.high))
        }
        _ => at(&one.state),
    }
}

/// A state is not known better than to rounding.
fn rounded(value: f64) -> String {
    let nothing = value.abs() < 1e-14;
    number(if nothing { 0.0 } else { value }, DIGITS)
}

fn eigenvalues(all: &[Complex<f64>]) -> String {
    let short = |value: f64| number(value, 5);
    let one = |value: &Complex<f64>| match value.im {
        im if im > 0.0 => Some(format!("{} ± {}i", short(value.re), short(im))),
        im if im < 0.0 => None,
        _ => Some(short(value.re)),
    };
    all.iter().filter_map(one).collect::<Vec<_>>().join(", ")
}

fn special(info: &ModelInfo, name: &str, branch: &EquilibriaRecord) -> String {
    let time = time_unit(info);
    let mut lines = format!("special\tkind\t{name}\tperiod\n");
    for point in &branch.special {
        let (kind, mark, r) = (point.kind, mark(point.artefact), number(point.r, 10));
        let period = point.period.map(|period| number(period, 10) + time);
        let period = period.unwrap_or_else(|| "-".to_owned());
        lines += &format!("{}\t{kind}{mark}\t{r}\t{period}\n", point.label);
    }
    lines
}

fn remarks(case: &Case, points: bool, special: bool) -> String {
    let what = match (points, special) {
        (false, false) => return String::new(),
        (true, false) => "the exact system has no equilibrium there, or one of the other stability",
        (false, true) => "the exact system has no such point there",
        (true, true) => {
            "the exact system has no such point there, and an equilibrium, if any, of the other stability"
        }
    };
    format!(
        "\n  * artefact of smoothing, {} only: {what}\n",
        case.dynamics
    )
}
