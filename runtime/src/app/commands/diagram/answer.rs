//! A diagram in all forms.

use serde_json::{Value, json};

use crate::app::answer::Answer;
use crate::app::axis::{along_axis, axis};
use crate::app::document::{Document, columns, logarithm};
use crate::app::section::unmet;
use crate::app::spreadsheet::{Columns, Row, Spreadsheet, headed};
use crate::app::text::{followed, heading, number, states, table, timed, work};
use crate::lyapunov::Lyapunov;
use crate::model::ModelInfo;
use crate::poincare::Section;
use crate::report::{Axis, Curve, Figure, Marker, Panel};
use crate::study::{Along, Case, DiagramRecord, Motion, Slice, SweepRecord};

/// A diagram in all forms, of which the picture shows these states.
pub(super) fn answer<'a>(
    info: &'a ModelInfo,
    case: &'a Case,
    record: &'a DiagramRecord,
    shown: &'a [usize],
) -> Answer<'a> {
    Answer::new(
        "diagram",
        || describe(info, case, record),
        || document(info, case, record),
    )
    .figure("diagram", move || picture(info, record, shown))
    .sheet("points", || all_points(info, record))
    .sheet("values", || all_values(info, record))
}

/// Digits shown of the design variable.
const DIGITS: usize = 6;

fn describe(info: &ModelInfo, case: &Case, record: &DiagramRecord) -> String {
    let name = &followed(info, &record.along);
    let section = record.diagram.section.describe(info);
    let what = format!("a Poincaré diagram along {name}, section {section}");
    let mut lines = format!("sweep\t{name}\tto\tvalues\tmotion\n");
    for sweep in &record.sweeps {
        let kind = |slice: &Slice| slice.motion.name();
        for run in sweep.slices.chunk_by(|a, b| kind(a) == kind(b)) {
            lines += &format!("{}\t{}\n", sweep.name, describe_run(run));
        }
    }
    let count: usize = record.sweeps.iter().map(|sweep| sweep.slices.len()).sum();
    let tail = format!("\n  {count} values; {}\n", work(&record.work()));
    heading(info, case, &what) + &table(&lines) + &elsewhere(info, record) + &tail
}

/// What `elsewhere` means, at the first value of each sweep where it is said.
fn elsewhere(info: &ModelInfo, record: &DiagramRecord) -> String {
    let name = record.along.name(info);
    let sentence = |sweep: &SweepRecord| {
        let mut seen = sweep.slices.iter();
        let (r, silence) = seen.find_map(|slice| Some((slice.r, slice.silence.as_ref()?)))?;
        let (r, why) = (
            number(r, DIGITS),
            unmet(info, &record.diagram.section, silence),
        );
        Some(format!("\n  elsewhere: at {name} = {r}, {why}\n"))
    };
    record.sweeps.iter().filter_map(sentence).collect()
}

/// Neighbouring values with the same kind of motion.
fn describe_run(run: &[Slice]) -> String {
    let end = |slice: Option<&Slice>| slice.map_or(String::new(), |s| number(s.r, DIGITS));
    let motion = run.first().map_or(String::new(), |s| s.motion.name());
    let (from, to, exponents) = (end(run.first()), end(run.last()), exponents(run));
    format!("{from}\t{to}\t{}\t{motion}{exponents}", run.len())
}

/// The range of the Lyapunov exponents of a run.
fn exponents(run: &[Slice]) -> String {
    let values = || run.iter().filter_map(exponent);
    let (low, high) = (
        values().fold(f64::INFINITY, f64::min),
        values().fold(f64::NEG_INFINITY, f64::max),
    );
    if low > high {
        return String::new();
    }
    format!(", exponent {} to {}", number(low, 3), number(high, 3))
}

/// The points over the design variable, each state upwards; exponents below them where there are any.
fn picture(info: &ModelInfo, record: &DiagramRecord, shown: &[usize]) -> Figure {
    let section = record.diagram.section.describe(info);
    let title = format!("{}: points on the section {section}", info.command);
    let mut caption = format!(
        "{} values; {} crossings left out, then {} noted at each. Where sweeps differ, there is more than one attractor.",
        record.diagram.values, record.diagram.settle, record.diagram.points
    );
    let slices = record.sweeps.iter().flat_map(|sweep| &sweep.slices);
    let empty = slices.filter(|slice| slice.points.is_empty()).count();
    if empty > 0 {
        caption += &format!(" At {empty} of them no point is seen: the table says why.");
    }
    let x = || {
        let (from, to) = (record.along.from, record.along.to);
        along_axis(info, &record.along).from(from.min(to), from.max(to))
    };
    let panel = |figure: Figure, &shown: &usize| {
        let state = info.states.get(shown);
        let y = state.map_or_else(|| Axis::new(""), |state| axis(state.name, state.unit));
        let clouds = record.sweeps.iter().enumerate().map(|(i, sweep)| {
            let points = sweep.slices.iter().flat_map(|slice| dots(slice, shown));
            // Where both sweeps have a point, both are seen.
            let marker = if i == 0 { Marker::Dot } else { Marker::Speck };
            Curve::points(sweep.name, i + 1, marker, points.collect())
        });
        figure.panel(Panel::new(x(), y).curves(clouds))
    };
    let figure = shown.iter().fold(Figure::new("1", &title, caption), panel);
    let exponents: Vec<Curve> = lines(record);
    if exponents.is_empty() {
        return figure;
    }
    let rate = timed(info, "largest Lyapunov exponent", "1/s");
    figure.panel(Panel::new(x(), Axis::new(&rate)).curves(exponents))
}

/// The points of a value, each once where they repeat.
fn dots(slice: &Slice, shown: usize) -> Vec<[f64; 2]> {
    let points = slice.points.iter().take(slice.different);
    points
        .filter_map(|point| Some([slice.r, *point.get(shown)?]))
        .collect()
}

fn lines(record: &DiagramRecord) -> Vec<Curve> {
    let curve = |(i, sweep): (usize, &SweepRecord)| {
        let point = |slice: &Slice| Some([slice.r, exponent(slice)?]);
        let points: Vec<[f64; 2]> = sweep.slices.iter().filter_map(point).collect();
        (!points.is_empty()).then(|| Curve::line(sweep.name, i + 1, points))
    };
    record.sweeps.iter().enumerate().filter_map(curve).collect()
}

/// A diagram; of one that was interrupted, how many values are not there.
fn document<'a>(info: &'a ModelInfo, case: &Case, record: &DiagramRecord) -> Document<'a> {
    let sweep = |sweep: &SweepRecord| {
        let section = &record.diagram.section;
        let values = sweep.slices.iter().map(|slice| value(info, section, slice));
        json!({ "sweep": sweep.name, "values": values.collect::<Vec<_>>() })
    };
    let missing = (record.missing > 0).then(|| json!({ "missing": record.missing }));
    Document::case(info, case)
        .range("along", &record.along)
        .put("section", record.diagram.section.describe(info))
        .put("settle", record.diagram.settle)
        .list("sweeps", &record.sweeps, sweep)
        .maybe("interrupted", missing)
        .units()
        .put("work", record.work())
}

/// One value of the design variable, its points as one column for each state.
fn value<'a>(info: &'a ModelInfo, section: &Section, slice: &Slice) -> Document<'a> {
    let period_count = match &slice.motion {
        Motion::Periodic(count) => Some(count),
        _ => None,
    };
    let reason = match (&slice.motion, &slice.silence) {
        (Motion::Failed(reason), _) => Some(reason.clone()),
        (_, Some(silence)) => Some(unmet(info, section, silence)),
        _ => None,
    };
    Document::new(info)
        .put("r", slice.r)
        .put("motion", slice.motion.name())
        .put("period_count", period_count)
        .states("points", columns(&slice.points, info.states.len()))
        .states("min", &slice.min)
        .states("max", &slice.max)
        .maybe("lyapunov", slice.lyapunov.as_ref().map(lyapunov))
        .maybe("reason", reason)
}

fn lyapunov(found: &Result<Lyapunov, String>) -> Value {
    match found {
        Ok(found) => json!({
            "exponent": logarithm(Some(found.exponent.unwrap_or(f64::NEG_INFINITY))),
            "error": found.exponent.map(|_| found.error), "time": found.time,
        }),
        Err(reason) => {
            json!({ "exponent": null, "error": null, "time": null, "failed": reason })
        }
    }
}

/// The columns of the points at the value `r` of what is followed.
pub(super) fn points<'a>(
    info: &ModelInfo,
    along: &Along,
    sweep: &'a str,
    r: f64,
) -> Columns<'a, Vec<f64>> {
    Columns::new()
        .column("sweep", move |_: &Vec<f64>| sweep.to_owned())
        .number(followed(info, along), move |_| r)
        .numbers(states(info, ""), |point, j| point.get(j).copied())
}

/// The columns of the values of a sweep.
pub(super) fn values<'a>(info: &ModelInfo, along: &Along, sweep: &'a str) -> Columns<'a, Slice> {
    let error = |slice: &Slice| {
        let error = exponent(slice).and(found(slice))?.error;
        error.is_finite().then_some(error)
    };
    Columns::new()
        .column("sweep", move |_: &Slice| sweep.to_owned())
        .number(followed(info, along), |slice| slice.r)
        .column("motion", |slice| slice.motion.name())
        .number(timed(info, "lyapunov", "1/s"), |slice| {
            Some(found(slice)?.exponent.unwrap_or(f64::NEG_INFINITY))
        })
        .number(timed(info, "lyapunov_error", "1/s"), error)
        .numbers(states(info, "min_"), |slice, j| slice.min.get(j).copied())
        .numbers(states(info, "max_"), |slice, j| slice.max.get(j).copied())
}

/// The largest Lyapunov exponent of a value, where it has one.
fn exponent(slice: &Slice) -> Option<f64> {
    found(slice)?.exponent
}

fn found(slice: &Slice) -> Option<&Lyapunov> {
    slice.lyapunov.as_ref()?.as_ref().ok()
}

/// One row for each point of a value.
pub(super) fn rows(info: &ModelInfo, along: &Along, sweep: &str, slice: &Slice) -> Vec<Row> {
    let columns = points(info, along, sweep, slice.r);
    slice
        .points
        .iter()
        .map(|point| columns.row(point))
        .collect()
}

fn all_points(info: &ModelInfo, record: &DiagramRecord) -> Spreadsheet {
    let along = &record.along;
    let rows = record.sweeps.iter().flat_map(|sweep| {
        let slices = sweep.slices.iter();
        slices.flat_map(|slice| rows(info, along, sweep.name, slice))
    });
    headed(points(info, along, "", 0.0).head(), rows)
}

fn all_values(info: &ModelInfo, record: &DiagramRecord) -> Spreadsheet {
    let along = &record.along;
    let rows = record.sweeps.iter().flat_map(|sweep| {
        let columns = values(info, along, sweep.name);
        let slices = sweep.slices.iter();
        slices.map(move |slice| columns.row(slice))
    });
    headed(values(info, along, "").head(), rows)
}
