//! Equilibria as text.

use nalgebra::Complex;

use crate::app::text::{followed, label, number, parameters, table, time_unit, timed};
use crate::model::ModelInfo;
use crate::study::{Case, EquilibriaRecord, EquilibriumRecord, SpecialEquilibrium};

const DIGITS: usize = 9;

/// A list of equilibria.
pub(super) fn list(info: &ModelInfo, case: &Case, found: &[EquilibriumRecord]) -> String {
    let title = format!("{}, {}: equilibria\n", info.command, case.dynamics);
    let mut text = format!("{title}  {}\n\n", parameters(info, case));
    text.push_str(&table(&rows(info, None, found)));
    text.push_str(&remarks(case, found.iter().any(|one| one.artefact), false));
    text
}

/// A branch of equilibria.
pub(super) fn describe(info: &ModelInfo, case: &Case, branch: &EquilibriaRecord) -> String {
    let (name, along) = (branch.along.name(info), followed(info, &branch.along));
    let mut text = format!(
        "{}, {}: a branch of equilibria along {name}\n  {}\n\n",
        info.command,
        case.dynamics,
        parameters(info, case)
    );
    text.push_str(&table(&rows(info, Some(&along), &branch.points)));
    if !branch.special.is_empty() {
        text.push_str(&format!("\n{}", table(&special(info, &along, branch))));
    }
    let points = branch.points.iter().any(|point| point.artefact);
    let special = branch.special.iter().any(|point| point.artefact);
    text.push_str(&remarks(case, points, special));
    text
}

fn rows(info: &ModelInfo, name: Option<&str>, all: &[EquilibriumRecord]) -> Vec<Vec<String>> {
    let states = info
        .states
        .iter()
        .map(|state| label(state.name, state.unit));
    let modes = all.iter().any(|one| one.mode.is_some());
    let mut head: Vec<String> = name.map(str::to_owned).into_iter().chain(states).collect();
    head.push(timed(info, "eigenvalues", "1/s"));
    head.push("stability".to_owned());
    if modes {
        head.push("mode".to_owned());
    }
    let row = |one: &EquilibriumRecord| {
        let mut row: Vec<String> = one.r.map(|r| number(r, DIGITS)).into_iter().collect();
        row.extend((0..info.states.len()).map(|j| state(one, j)));
        row.push(eigenvalues(&one.eigenvalues));
        let mark = if one.artefact { " *" } else { "" };
        row.push(format!("{}{mark}", one.stability.name()));
        row.extend(one.mode.clone());
        row
    };
    std::iter::once(head).chain(all.iter().map(row)).collect()
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

fn special(info: &ModelInfo, name: &str, branch: &EquilibriaRecord) -> Vec<Vec<String>> {
    let head = ["special", "kind", name, "period"].map(str::to_owned);
    let time = time_unit(info);
    let row = |point: &SpecialEquilibrium| {
        let mark = if point.artefact { " *" } else { "" };
        vec![
            point.label.clone(),
            format!("{}{mark}", point.kind),
            number(point.r, 10),
            point
                .period
                .map_or_else(|| "-".to_owned(), |period| number(period, 10) + time),
        ]
    };
    std::iter::once(head.to_vec())
        .chain(branch.special.iter().map(row))
        .collect()
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
