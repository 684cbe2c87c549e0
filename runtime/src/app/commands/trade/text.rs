//! A trade as text.

use crate::app::spreadsheet::head as words;
use crate::app::text::{digits, followed, number, parameters, short, table, time_unit, timed};
use crate::field::Kernel;
use crate::model::ModelInfo;
use crate::study::trade::{Cost, Curve, Need, Point, Setting, Trade};
use crate::study::{Case, End, TradeRecord};

pub(super) fn describe(
    info: &ModelInfo,
    case: &Case,
    record: &TradeRecord,
    accuracy: Option<f64>,
) -> String {
    let mut text = format!("{}: what smoothing costs\n", info.command);
    for end in &record.ends {
        let here = Case {
            parameters: end.parameters.clone(),
            ..case.clone()
        };
        text.push_str(&format!("\n  {}\n\n", parameters(info, &here)));
        text.push_str(&at_end(info, end, accuracy));
    }
    if let (Some(along), Some(accuracy)) = (&record.along, accuracy) {
        let name = along.name(info);
        text.push_str(&format!(
            "\njudged at the worst end of {name} = {}..{}, for the accuracy {}\n\n",
            short(along.from),
            short(along.to),
            short(accuracy)
        ));
        let head = followed(info, along);
        text.push_str(&table(&worst(record, &head, [along.from, along.to])));
    }
    text
}

fn at_end(info: &ModelInfo, end: &End, accuracy: Option<f64>) -> String {
    let trade = &end.trade;
    let period = number(trade.exact.period, digits(1e-10)) + time_unit(info);
    let mut text = format!(
        "  exact: period {period}, {} per period\n\n",
        microseconds(&trade.exact.cost)
    );
    text.push_str(&table(&errors(info, trade)));
    if trade.curves.iter().any(|curve| curve.frequency.is_some()) {
        text.push_str(&format!("\n{}", table(&fits(info, trade))));
    }
    for line in remarks(trade) {
        text.push_str(&format!("\n  {line}\n"));
    }
    if let Some(accuracy) = accuracy {
        text.push_str(&format!("\n  for the accuracy {}:\n\n", short(accuracy)));
        text.push_str(&table(&needs(trade)));
    }
    text
}

fn microseconds(cost: &Cost) -> String {
    format!("{:.0} us", 1e6 * cost.seconds)
}

fn errors(info: &ModelInfo, trade: &Trade) -> Vec<Vec<String>> {
    let mut head = words([
        "smoothing",
        &timed(info, "stiffness", "1/s"),
        "e_f",
        "predicted",
    ]);
    for state in info.states {
        head.extend([format!("e_{}", state.name), "predicted".to_owned()]);
    }
    head.extend(words(["steps", "one period"]));
    let mut rows = vec![head];
    for curve in &trade.curves {
        rows.extend(curve.points.iter().map(|point| row(curve, point)));
    }
    rows
}

/// An error with its prediction; a question mark where the prediction doubts itself.
fn row(curve: &Curve, point: &Point) -> Vec<String> {
    let small = |value: f64| number(value, 3);
    let predicted = point.predicted.as_ref().ok();
    let doubt = |value: f64| match predicted {
        Some(found) if !found.doubts.is_empty() => small(value) + "?",
        _ => small(value),
    };
    let told = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), doubt);
    let mut row = vec![
        curve.at(point.size).to_string(),
        number(point.stiffness, 2),
        small(point.frequency),
        told(predicted.map(|found| found.frequency)),
    ];
    for (j, &error) in point.max_abs.iter().enumerate() {
        let found = predicted.and_then(|found| found.max_abs.get(j).copied().flatten());
        row.extend([small(error), told(found)]);
    }
    row.push(point.cost.work.steps.to_string());
    row.push(microseconds(&point.cost));
    row
}

fn fits(info: &ModelInfo, trade: &Trade) -> Vec<Vec<String>> {
    let mut head = words(["e = b size^a", "e_f: a", "b"]);
    for state in info.states {
        head.extend([format!("e_{}: a", state.name), "b".to_owned()]);
    }
    let mut rows = vec![head];
    for curve in trade
        .curves
        .iter()
        .filter(|curve| curve.frequency.is_some())
    {
        let mut row = vec![curve.kernel.to_string()];
        for fit in std::iter::once(&curve.frequency).chain(&curve.max_abs) {
            match fit {
                Some(fit) => row.extend([number(fit.a, 3), number(fit.b, 3)]),
                None => row.extend(words(["-", "-"])),
            }
        }
        rows.push(row);
    }
    rows
}

/// What was refused or lost, and why predictions doubt themselves.
fn remarks(trade: &Trade) -> Vec<String> {
    let mut lines = Vec::new();
    for curve in &trade.curves {
        if let Some(reason) = &curve.refused {
            lines.push(format!("{}: {reason}", curve.kernel));
        }
        for (size, reason) in &curve.lost {
            lines.push(format!("{}: no orbit: {reason}", curve.at(*size)));
        }
    }
    let doubtful =
        |point: &Point| !matches!(&point.predicted, Ok(found) if found.doubts.is_empty());
    if trade.curves.iter().any(|c| c.points.iter().any(doubtful)) {
        lines.push("? outside the asymptotic range of the prediction; --json says why".to_owned());
    }
    lines
}

fn needs(trade: &Trade) -> Vec<Vec<String>> {
    let mut rows = vec![words([
        "",
        "for e_f alone",
        "error",
        "tolerance",
        "steps",
        "one period",
    ])];
    rows.push(match &trade.need {
        Some(Ok(setting)) => with(words(["exact", "-"]), setting),
        Some(Err(reason)) => vec!["exact".to_owned(), reason.clone()],
        None => words(["exact"]),
    });
    for curve in &trade.curves {
        if let Some(need) = &curve.need {
            rows.push(needed(curve.kernel, need));
        }
    }
    rows
}

fn needed(kernel: Kernel, need: &Result<Need, String>) -> Vec<String> {
    match need {
        Ok(need) => {
            let name = format!("{kernel}:{}", number(need.smoothing.size, 3));
            with(vec![name, number(need.frequency_size, 3)], &need.setting)
        }
        Err(reason) => vec![kernel.to_string(), reason.clone()],
    }
}

fn with(mut row: Vec<String>, setting: &Setting) -> Vec<String> {
    row.extend([
        number(setting.error, 3),
        number(setting.tolerance, 2),
        setting.cost.work.steps.to_string(),
        microseconds(&setting.cost),
    ]);
    row
}

fn worst(record: &TradeRecord, head: &str, values: [f64; 2]) -> Vec<Vec<String>> {
    let mut rows = vec![words([
        head,
        "",
        "for e_f alone",
        "error",
        "tolerance",
        "steps",
        "one period",
    ])];
    for kernel in Kernel::ALL {
        if let Some((end, need)) = record.need(kernel) {
            let mut row = vec![values.get(end).copied().map_or(String::new(), short)];
            row.extend(needed(kernel, &need));
            rows.push(row);
        }
    }
    rows
}
