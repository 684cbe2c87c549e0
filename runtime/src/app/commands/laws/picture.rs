//! A law as a figure.

use super::curve::{Sample, with_unit};
use super::exhibit::Drawn;
use crate::report::{self, Axis, Figure, Panel};

impl Drawn {
    /// Force against relative speed, the copy behind.
    pub(super) fn figure(&self) -> Figure {
        let curve = &self.curve;
        let [speed, force] = curve.units;
        let points = |of: fn(&Sample) -> Option<f64>| {
            let samples = curve.samples.iter();
            samples
                .filter_map(|sample| Some([sample.speed, of(sample)?]))
                .collect::<Vec<_>>()
        };
        let copy = curve.smoothing.map(|smoothing| {
            let points = points(|sample| sample.copy);
            report::Curve::line(smoothing.to_string(), 1, points)
        });
        let exact = report::Curve::line(self.law.name, 0, points(|sample| sample.force));
        let panel = Panel::new(
            Axis::new(&with_unit("relative speed", speed)).from(-curve.speed, curve.speed),
            Axis::new(&with_unit("friction force opposing it", force)),
        );
        Figure::new("law", &self.name, "").panel(panel.curves(copy).curve(exact))
    }
}
