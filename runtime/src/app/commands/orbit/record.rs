//! An orbit in all forms: as text, as JSON, and as a row of a table.

use crate::app::document::{Document, logarithm};
use crate::app::harmonics;
use crate::app::request::Request;
use crate::app::spreadsheet::{Columns, part, parts};
use crate::app::text::{
    beside, digits, followed, heading, label, line, number, states as named, table, time_unit,
    timed, work,
};
use crate::model::{ModelInfo, Unit};
use crate::study::{Along, Case, OrbitRecord};

/// All but what it cost.
pub(in crate::app::commands) fn document<'a>(
    info: &'a ModelInfo,
    orbit: &OrbitRecord,
) -> Document<'a> {
    Document::new(info)
        .put("model", info.command)
        .put("dynamics", orbit.dynamics.to_string())
        .parameters(&orbit.parameters)
        .all(&point(info, orbit))
        .units()
}

/// What tells an orbit from others of the same model.
pub(in crate::app::commands) fn point<'a>(
    info: &'a ModelInfo,
    orbit: &OrbitRecord,
) -> Document<'a> {
    let floquet = &orbit.floquet;
    // With a drive there is no trivial multiplier.
    let trivial = info.drive.is_none().then_some(floquet.trivial_error);
    let logs = (0..floquet.multipliers.len()).map(|j| logarithm(log_modulus(orbit, j)));
    Document::new(info)
        .maybe("r", orbit.r)
        .put("period", orbit.period)
        .put("frequency", 1.0 / orbit.period)
        .states("state", &orbit.state)
        .modes(&orbit.modes)
        .states("max", &orbit.max)
        .states("min", &orbit.min)
        .states("max_abs", &orbit.max_abs)
        .put("period_count", orbit.period_count)
        .maybe_states("shift", orbit.shift.as_ref())
        .put("multipliers", &floquet.multipliers)
        .put("log_abs_multipliers", logs.collect::<Vec<_>>())
        .put("trivial_multiplier_error", trivial)
        .put("stability", floquet.stability.name())
        .put("held", &orbit.held)
        .put("word", &orbit.word)
        .maybe("harmonics", harmonics::document(info, orbit))
        .put("residual", orbit.residual)
        .put("error_estimate", orbit.error_estimate)
}

/// The logarithm of the modulus of a multiplier: that of one that is exactly zero is negative infinity.
fn log_modulus(orbit: &OrbitRecord, j: usize) -> Option<f64> {
    let nothing = orbit.floquet.multipliers.get(j)?.norm() == 0.0;
    let known = orbit.floquet.log_moduli.get(j).copied().flatten();
    known.or_else(|| nothing.then_some(f64::NEG_INFINITY))
}

/// Its columns among orbits along a design variable, with those of these harmonics.
pub(in crate::app::commands) fn columns(
    info: &ModelInfo,
    along: &Along,
    orders: &[usize],
) -> Columns<'static, OrbitRecord> {
    let count = info.states.len().saturating_sub(1);
    let states = |prefix| named(info, prefix);
    // One place for each multiplier, even if the eigenvalues could not be found.
    let multiplier = |orbit: &OrbitRecord, j: usize| match j % 3 {
        2 => log_modulus(orbit, j / 3),
        side => part(&orbit.floquet.multipliers, j / 3 * 2 + side),
    };
    let columns = Columns::new()
        .number(followed(info, along), |orbit: &OrbitRecord| orbit.r)
        .number(timed(info, "period", "s"), |orbit| orbit.period)
        .column("stability", |orbit| orbit.floquet.stability.name())
        .count("period_count", |orbit| orbit.period_count)
        .numbers(states(""), |orbit, j| orbit.state.get(j).copied())
        .numbers(states("max_"), |orbit, j| orbit.max.get(j).copied())
        .numbers(states("min_"), |orbit, j| orbit.min.get(j).copied())
        .numbers(states("max_abs_"), |orbit, j| orbit.max_abs.get(j).copied())
        .numbers(
            parts("multiplier", count, &["re", "im", "log_abs"]),
            multiplier,
        )
        .number("residual", |orbit| orbit.residual)
        .number("error_estimate", |orbit| orbit.error_estimate);
    harmonics::all(columns, info, orders)
}

/// Its columns on the terminal, with these states.
pub(in crate::app::commands) fn shown(
    asked: &Request<'_>,
    along: &Along,
    states: &[usize],
) -> Columns<'static, OrbitRecord> {
    let info = asked.info;
    let shown = |orbit: &OrbitRecord, value: Option<f64>| {
        let digits = digits(orbit.error_estimate).min(9);
        value.map_or(String::new(), |value| number(value, digits))
    };
    let multiplier = |orbit: &OrbitRecord| {
        let largest = orbit.floquet.multipliers.first();
        largest.map_or(String::new(), |largest| number(largest.norm(), 5))
    };
    let mut columns = Columns::new()
        .column(followed(info, along), move |orbit: &OrbitRecord| {
            shown(orbit, orbit.r)
        })
        .column(timed(info, "period", "s"), move |orbit| {
            shown(orbit, Some(orbit.period))
        });
    for &j in states {
        let (name, unit) = largest(info, j);
        columns = columns.column(label(&name, unit), move |orbit| {
            shown(orbit, orbit.max_abs.get(j).copied())
        });
        for &order in &asked.case.harmonics {
            columns = harmonics::rounded(columns, info, order, j);
        }
    }
    columns
        .column("|multiplier|", multiplier)
        .column("stability", |orbit| orbit.floquet.stability.name())
}

/// What the largest magnitude of a state is called, and its unit.
pub(in crate::app::commands) fn largest(info: &ModelInfo, j: usize) -> (String, Option<Unit>) {
    let state = info.states.get(j);
    let name = format!("max |{}|", state.map_or("", |state| state.name));
    (name, state.and_then(|state| state.unit))
}

pub(super) fn describe(info: &ModelInfo, case: &Case, orbit: &OrbitRecord) -> String {
    let stability = orbit.floquet.stability.name();
    let tables = [
        period(info, orbit),
        states(info, orbit),
        harmonics::lines(info, orbit),
        multipliers(orbit),
        quality(info, orbit),
    ];
    let tables = tables.iter().filter(|lines| !lines.is_empty());
    let tables: Vec<String> = tables.map(|lines| table(lines)).collect();
    heading(info, case, &format!("a periodic orbit, {stability}")) + &tables.join("\n")
}

fn period(info: &ModelInfo, orbit: &OrbitRecord) -> String {
    let digits = digits(orbit.error_estimate);
    let time = time_unit(info);
    let inverse = if time.is_empty() { "" } else { " 1/s" };
    let [period, frequency] = [orbit.period, 1.0 / orbit.period].map(|value| number(value, digits));
    let word = orbit.word.iter().map(|word| format!("word\t{word}\n"));
    format!(
        "period\t{period}{time}\nfrequency\t{frequency}{inverse}\ncrossings\t{}\n{}",
        orbit.period_count,
        word.collect::<String>()
    )
}

fn states(info: &ModelInfo, orbit: &OrbitRecord) -> String {
    let digits = digits(orbit.error_estimate);
    let gain = if orbit.shift.is_some() { "\tgain" } else { "" };
    let mut lines = format!("state\tstart\tmin\tmax\tmax abs{gain}\n");
    for (j, state) in info.states.iter().enumerate() {
        let largest = orbit.max_abs.get(j).copied().unwrap_or(0.0);
        let show = |value: f64| beside(value, largest, digits);
        let columns = [&orbit.state, &orbit.min, &orbit.max, &orbit.max_abs].into_iter();
        let columns = columns.chain(&orbit.shift);
        let values = columns.map(|column| column.get(j).copied().map_or(String::new(), show));
        lines += &line([label(state.name, state.unit)].into_iter().chain(values));
    }
    lines
}

fn multipliers(orbit: &OrbitRecord) -> String {
    let mut lines = "multiplier\tln |multiplier|\n".to_owned();
    let floquet = &orbit.floquet;
    for (j, multiplier) in floquet.multipliers.iter().enumerate() {
        let [re, im] = [multiplier.re, multiplier.im.abs()].map(|part| number(part, 8));
        let log = log_modulus(orbit, j).map_or_else(|| "-".to_owned(), |log| number(log, 8));
        lines += &match multiplier.im {
            0.0 => format!("{re}\t{log}\n"),
            below if below < 0.0 => format!("{re} - {im}i\t{log}\n"),
            _ => format!("{re} + {im}i\t{log}\n"),
        };
    }
    for held in &orbit.held {
        let value = number(held.value, digits(orbit.error_estimate));
        let (what, how) = (
            &held.combination,
            if held.conserved {
                "never changes"
            } else {
                "is free"
            },
        );
        lines += &format!("1 (neutral: {what} {how}; held at {value})\t0\n");
    }
    lines
}

fn quality(info: &ModelInfo, orbit: &OrbitRecord) -> String {
    let [error, residual, off] = [
        orbit.error_estimate,
        orbit.residual,
        orbit.floquet.trivial_error,
    ]
    .map(|value| number(value, 2));
    let mut lines = format!("error estimate\t{error}\nresidual\t{residual}\n");
    if info.drive.is_none() {
        lines += &format!("trivial multiplier off by\t{off}\n");
    }
    lines + &format!("work\t{}\n", work(&orbit.work))
}
