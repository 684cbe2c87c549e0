//! A curve of special points in the plane of its two parameters.

use crate::app::text::{followed, timed};
use crate::model::ModelInfo;
use crate::report::{Axis, Curve, Figure, Marker, Panel};
use crate::study::CurveRecord;

/// The curve with its special points, and the period along it.
pub(super) fn picture(info: &ModelInfo, curve: &CurveRecord) -> Figure {
    let [p, q] = [&curve.along, &curve.and].map(|range| Axis::new(&followed(info, range)));
    let places: Vec<[f64; 2]> = curve.points.iter().map(|one| [one.q, one.p]).collect();
    let periods = curve.points.iter().map(|one| [one.q, one.period]);
    let period = Curve::line(curve.kind.name(), 0, periods.collect());
    let mut plane = Panel::new(q.clone(), p).curve(Curve::line(curve.kind.name(), 0, places));
    for (i, one) in curve.special.iter().enumerate() {
        let label = format!("{} ({})", one.label, one.kind);
        let at = vec![[one.point.q, one.point.p]];
        plane = plane.curve(Curve::points(label, 2 + i, Marker::Diamond, at));
    }
    Figure::new("", info.name, String::new())
        .columns(2)
        .panel(plane)
        .panel(Panel::new(q, Axis::new(&timed(info, "period", "s"))).curve(period))
}
