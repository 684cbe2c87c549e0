//! Holds what the program answered against what a case expects.

use serde_json::Value;

use crate::case::{Case, Expected};

/// What the program answered.
pub(crate) struct Answer<'a> {
    pub(crate) exit: Option<i32>,
    pub(crate) stdout: &'a [u8],
    pub(crate) stderr: &'a str,
}

/// What falls short; empty if the case passes.
pub(crate) fn shortcomings(case: &Case, answer: &Answer<'_>) -> Vec<String> {
    let stderr = answer.stderr.trim();
    if answer.exit != Some(case.exit) {
        let (exit, wanted) = (answer.exit, case.exit);
        return vec![format!("exit {exit:?}, expected {wanted}: {stderr}")];
    }
    if !stderr.contains(&case.stderr) {
        return vec![format!("stderr lacks `{}`: {stderr}", case.stderr)];
    }
    if case.exit != 0 {
        return Vec::new();
    }
    match serde_json::from_slice(answer.stdout) {
        Ok(document) => wrong_values(case, &document),
        Err(error) => vec![format!("stdout is no JSON document: {error}")],
    }
}

fn wrong_values(case: &Case, document: &Value) -> Vec<String> {
    let values = case
        .expect
        .iter()
        .filter_map(|(path, expected)| differs(path, at(document, path), expected));
    let points = case
        .special
        .iter()
        .filter_map(|(kind, r, tolerance)| absent(document, kind, *r, *tolerance));
    values.chain(points).collect()
}

/// The place that `path`, for instance `multipliers.0.0`, names.
fn at<'a>(document: &'a Value, path: &str) -> Option<&'a Value> {
    path.split('.').try_fold(document, |value, key| {
        if value.is_array() {
            value.get(key.parse::<usize>().ok()?)
        } else {
            value.get(key)
        }
    })
}

fn differs(path: &str, found: Option<&Value>, expected: &Expected) -> Option<String> {
    let Some(found) = found else {
        return Some(format!("{path} is missing"));
    };
    match expected {
        Expected::Same(value) => {
            (found != value).then(|| format!("{path} is {found}, not {value}"))
        }
        Expected::Number {
            value,
            tolerance,
            scale,
        } => {
            let Some(number) = found.as_f64() else {
                return Some(format!("{path} is {found}, not a number"));
            };
            let error = (number - value).abs() / if *scale == 0.0 { 1.0 } else { *scale };
            // A NaN must not pass.
            let passes = error <= *tolerance;
            (!passes).then(|| {
                let (digits, wanted) = (-error.log10(), -tolerance.log10());
                format!(
                    "{path} has {digits:.1} of {wanted:.0} digits: {number:e}, expected {value:e}"
                )
            })
        }
    }
}

fn absent(document: &Value, kind: &str, r: f64, tolerance: f64) -> Option<String> {
    let nearest = document["special"]
        .as_array()
        .into_iter()
        .flatten()
        .filter(|point| point["kind"] == kind)
        .filter_map(|point| point["r"].as_f64())
        .min_by(|a, b| (a - r).abs().total_cmp(&(b - r).abs()));
    let good = nearest.is_some_and(|found| (found - r).abs() <= tolerance * r.abs());
    (!good).then(|| format!("no {kind} at {r}; the nearest is at {nearest:?}"))
}
