//! A Poincaré diagram as a figure.

use crate::app::chart::{along_axis, axis};
use crate::app::text::timed;
use crate::model::ModelInfo;
use crate::report::{Axis, Curve, Figure, Marker, Panel};
use crate::study::{DiagramRecord, Slice, SweepRecord};

/// The points over the design variable, state number `shown` upwards; exponents below them where there are any.
pub(super) fn picture(info: &ModelInfo, record: &DiagramRecord, shown: usize) -> Figure {
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
    let state = info.states.get(shown);
    let x = || {
        let (from, to) = (record.along.from, record.along.to);
        along_axis(info, &record.along).from(from.min(to), from.max(to))
    };
    let y = state.map_or_else(|| Axis::new(""), |state| axis(state.name, state.unit));
    let clouds = record.sweeps.iter().enumerate().map(|(i, sweep)| {
        let points = sweep.slices.iter().flat_map(|slice| dots(slice, shown));
        Curve::points(sweep.name, i + 1, Marker::Dot, points.collect())
    });
    let figure = Figure::new("1", &title, caption).panel(Panel::new(x(), y).curves(clouds));
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
    let exponent = |slice: &Slice| slice.lyapunov.as_ref()?.as_ref().ok()?.exponent;
    let curve = |(i, sweep): (usize, &SweepRecord)| {
        let point = |slice: &Slice| Some([slice.r, exponent(slice)?]);
        let points: Vec<[f64; 2]> = sweep.slices.iter().filter_map(point).collect();
        (!points.is_empty()).then(|| Curve::line(sweep.name, i + 1, points))
    };
    record.sweeps.iter().enumerate().filter_map(curve).collect()
}
