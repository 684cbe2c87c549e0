//! A trade as text.

use crate::app::text::{
    digits, followed, line, number, parameters, short, table, time_unit, timed,
};
use crate::field::Kernel;
use crate::model::ModelInfo;
use crate::study::predict::Prediction;
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

fn errors(info: &ModelInfo, trade: &Trade) -> String {
    let stiffness = timed(info, "stiffness", "1/s");
    let states = info.states.iter();
    let states: String = states
        .map(|state| format!("\te_{}\tpredicted", state.name))
        .collect();
    let mut lines = format!("smoothing\t{stiffness}\te_f\tpredicted{states}\tsteps\tone period\n");
    for curve in &trade.curves {
        lines.extend(curve.points.iter().map(|point| row(curve, point)));
    }
    lines
}

/// An error with its prediction; a question mark where the prediction doubts itself.
fn row(curve: &Curve, point: &Point) -> String {
    let small = |value: f64| number(value, 3);
    let predicted = point.predicted.as_ref().ok();
    let told = |value: Option<f64>, doubtful: bool| {
        let mark = if doubtful { "?" } else { "" };
        value.map_or_else(|| "-".to_owned(), |value| small(value) + mark)
    };
    let doubts = predicted.is_some_and(|found| !found.doubts.is_empty());
    let mut row = vec![
        curve.at(point.size).to_string(),
        number(point.stiffness, 2),
        small(point.frequency),
        told(predicted.map(|found| found.frequency), doubts),
    ];
    for (j, &error) in point.max_abs.iter().enumerate() {
        let found = predicted.and_then(|found| found.max_abs.get(j).copied().flatten());
        let doubtful = predicted.is_some_and(|found| found.doubts_peak(j));
        row.extend([small(error), told(found, doubtful)]);
    }
    row.extend([point.cost.work.steps.to_string(), microseconds(&point.cost)]);
    line(row)
}

fn fits(info: &ModelInfo, trade: &Trade) -> String {
    let states = info.states.iter();
    let states: String = states
        .map(|state| format!("\te_{}: a\tb", state.name))
        .collect();
    let mut lines = format!("e = b size^a\te_f: a\tb{states}\n");
    for curve in trade
        .curves
        .iter()
        .filter(|curve| curve.frequency.is_some())
    {
        let fits = std::iter::once(&curve.frequency).chain(&curve.max_abs);
        let cells = fits.map(|fit| match fit {
            Some(fit) => format!("{}\t{}", number(fit.a, 3), number(fit.b, 3)),
            None => "-\t-".to_owned(),
        });
        lines += &line([curve.kernel.to_string()].into_iter().chain(cells));
    }
    lines
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
    let certain = |found: &Prediction| {
        found.doubts.is_empty() && !found.cancelling.iter().any(|cancels| *cancels)
    };
    let doubtful = |point: &Point| !point.predicted.as_ref().is_ok_and(certain);
    if trade.curves.iter().any(|c| c.points.iter().any(doubtful)) {
        lines.push("? outside the asymptotic range of the prediction, or what is left where contributions cancel; --json says which".to_owned());
    }
    lines
}

/// What the columns of settings hold, after that of their names.
const SETTING: &str = "for e_f alone\terror\ttolerance\tsteps\tone period";

fn needs(trade: &Trade) -> String {
    let mut lines = format!("\t{SETTING}\nexact");
    lines += &match &trade.need {
        Some(Ok(found)) => format!("\t-\t{}\n", setting(found)),
        Some(Err(reason)) => format!("\t{reason}\n"),
        None => "\n".to_owned(),
    };
    for curve in &trade.curves {
        if let Some(need) = &curve.need {
            lines += &needed(curve.kernel, need);
        }
    }
    lines
}

fn needed(kernel: Kernel, need: &Result<Need, String>) -> String {
    match need {
        Ok(need) => {
            let [size, alone] = [need.smoothing.size, need.frequency_size].map(|s| number(s, 3));
            format!("{kernel}:{size}\t{alone}\t{}\n", setting(&need.setting))
        }
        Err(reason) => format!("{kernel}\t{reason}\n"),
    }
}

fn setting(found: &Setting) -> String {
    let (error, tolerance) = (number(found.error, 3), number(found.tolerance, 2));
    let (steps, period) = (found.cost.work.steps, microseconds(&found.cost));
    format!("{error}\t{tolerance}\t{steps}\t{period}")
}

fn worst(record: &TradeRecord, head: &str, values: [f64; 2]) -> String {
    let mut lines = format!("{head}\t\t{SETTING}\n");
    for kernel in Kernel::ALL {
        if let Some((end, need)) = record.need(kernel) {
            let value = values.get(end).copied().map_or(String::new(), short);
            lines += &format!("{value}\t{}", needed(kernel, &need));
        }
    }
    lines
}
