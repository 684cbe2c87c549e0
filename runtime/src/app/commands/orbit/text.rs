//! An orbit as text.

use crate::app::harmonics;
use crate::app::text::{digits, heading, label, line, number, table, time_unit, work};
use crate::model::ModelInfo;
use crate::study::{Case, OrbitRecord};

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
    let mut lines = "state\tstart\tmin\tmax\tmax abs\n".to_owned();
    for (j, state) in info.states.iter().enumerate() {
        let largest = orbit.max_abs.get(j).copied().unwrap_or(0.0);
        let show = |value: f64| {
            let rounding = value.abs() <= f64::EPSILON * largest;
            number(if rounding { 0.0 } else { value }, digits)
        };
        let columns = [&orbit.state, &orbit.min, &orbit.max, &orbit.max_abs];
        let values = columns.map(|column| column.get(j).copied().map_or(String::new(), show));
        lines += &line([label(state.name, state.unit)].into_iter().chain(values));
    }
    lines
}

fn multipliers(orbit: &OrbitRecord) -> String {
    let mut lines = "multiplier\tln |multiplier|\n".to_owned();
    let floquet = &orbit.floquet;
    for (multiplier, log) in floquet.multipliers.iter().zip(&floquet.log_moduli) {
        let [re, im] = [multiplier.re, multiplier.im.abs()].map(|part| number(part, 8));
        let log = log.map_or_else(|| "-".to_owned(), |log| number(log, 8));
        lines += &match multiplier.im {
            0.0 => format!("{re}\t{log}\n"),
            below if below < 0.0 => format!("{re} - {im}i\t{log}\n"),
            _ => format!("{re} + {im}i\t{log}\n"),
        };
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
