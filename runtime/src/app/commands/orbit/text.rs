//! An orbit as text.

use crate::app::text::{digits, label, number, parameters, table, time_unit, work};
use crate::model::ModelInfo;
use crate::study::{Case, OrbitRecord};

pub(super) fn describe(info: &ModelInfo, case: &Case, orbit: &OrbitRecord) -> String {
    let stability = orbit.floquet.stability.name();
    [
        format!(
            "{}, {}: a periodic orbit, {stability}\n",
            info.command, case.dynamics
        ),
        format!("  {}\n\n", parameters(info, case)),
        table(&period(info, orbit)),
        "\n".to_owned(),
        table(&states(info, orbit)),
        "\n".to_owned(),
        table(&multipliers(orbit)),
        "\n".to_owned(),
        table(&quality(info, orbit)),
    ]
    .concat()
}

fn period(info: &ModelInfo, orbit: &OrbitRecord) -> Vec<Vec<String>> {
    let digits = digits(orbit.error_estimate);
    let time = time_unit(info);
    let inverse = if time.is_empty() { "" } else { " 1/s" };
    let mut rows = vec![
        vec!["period".to_owned(), number(orbit.period, digits) + time],
        vec![
            "frequency".to_owned(),
            number(1.0 / orbit.period, digits) + inverse,
        ],
        vec!["crossings".to_owned(), orbit.period_count.to_string()],
    ];
    if let Some(word) = &orbit.word {
        rows.push(vec!["word".to_owned(), word.clone()]);
    }
    rows
}

fn states(info: &ModelInfo, orbit: &OrbitRecord) -> Vec<Vec<String>> {
    let digits = digits(orbit.error_estimate);
    let mut rows = vec![
        ["state", "start", "min", "max", "max abs"]
            .map(str::to_owned)
            .to_vec(),
    ];
    for (j, state) in info.states.iter().enumerate() {
        let largest = orbit.max_abs.get(j).copied().unwrap_or(0.0);
        let show = |value: f64| {
            let rounding = value.abs() <= f64::EPSILON * largest;
            number(if rounding { 0.0 } else { value }, digits)
        };
        let columns = [&orbit.state, &orbit.min, &orbit.max, &orbit.max_abs];
        let mut row = vec![label(state.name, state.unit)];
        row.extend(columns.map(|column| column.get(j).copied().map_or(String::new(), show)));
        rows.push(row);
    }
    rows
}

fn multipliers(orbit: &OrbitRecord) -> Vec<Vec<String>> {
    let mut rows = vec![
        ["multiplier", "ln |multiplier|"]
            .map(str::to_owned)
            .to_vec(),
    ];
    let floquet = &orbit.floquet;
    for (multiplier, log) in floquet.multipliers.iter().zip(&floquet.log_moduli) {
        let value = match multiplier.im {
            0.0 => number(multiplier.re, 8),
            im => format!(
                "{} {} {}i",
                number(multiplier.re, 8),
                sign(im),
                number(im.abs(), 8)
            ),
        };
        let log = log.map_or_else(|| "-".to_owned(), |log| number(log, 8));
        rows.push(vec![value, log]);
    }
    rows
}

fn sign(value: f64) -> char {
    if value < 0.0 { '-' } else { '+' }
}

fn quality(info: &ModelInfo, orbit: &OrbitRecord) -> Vec<Vec<String>> {
    let small = |value| number(value, 2);
    let mut rows = vec![
        vec!["error estimate".to_owned(), small(orbit.error_estimate)],
        vec!["residual".to_owned(), small(orbit.residual)],
    ];
    if info.drive.is_none() {
        let off = small(orbit.floquet.trivial_error);
        rows.push(vec!["trivial multiplier off by".to_owned(), off]);
    }
    rows.push(vec!["work".to_owned(), work(&orbit.work)]);
    rows
}
