//! A branch drawn: stable and unstable stretches, with its special points.

use super::text::{followed, label};
use crate::bifurcation::{Kind, Stability};
use crate::field::Design;
use crate::model::{ModelInfo, Unit};
use crate::report::{Axis, Curve, Marker, Panel};
use crate::study::Along;

/// The axis of a quantity, with its unit if it has one.
pub(super) fn axis(name: &str, unit: Option<Unit>) -> Axis {
    Axis::new(&label(name, unit))
}

/// The axis of what is followed: a size of smoothing by its logarithm.
pub(super) fn along_axis(info: &ModelInfo, along: &Along) -> Axis {
    let axis = Axis::new(&followed(info, along));
    if along.design == Design::Smoothing {
        axis.logarithmic()
    } else {
        axis
    }
}

/// A point of a branch to be drawn: the design variable with the value shown, and its stability.
pub(super) type Point = ([f64; 2], Stability);

/// A special point to be drawn.
#[derive(Debug, Clone)]
pub(super) struct Mark {
    pub(super) kind: Kind,
    pub(super) label: String,
    /// How many points of its branch precede it.
    pub(super) after: usize,
    pub(super) at: [f64; 2],
}

/// Where a stretch passes, and what is known of the stability there.
type Vertex = ([f64; 2], Option<Stability>);

/// A panel that gathers stretches of equal stability and special points of equal kind.
pub(super) struct Chart {
    panel: Panel,
    marks: Vec<Mark>,
}

impl Chart {
    pub(super) const fn new(panel: Panel) -> Self {
        Self {
            panel,
            marks: Vec::new(),
        }
    }

    /// Adds a branch.
    pub(super) fn add(&mut self, points: Vec<Point>, marks: Vec<Mark>) {
        // A special point at an end stands before the last point, or after the first one.
        let most = points.len().saturating_sub(1).max(1);
        let mut vertices: Vec<Vertex> = Vec::new();
        for ((at, stability), count) in points.into_iter().zip(1..) {
            vertices.push((at, Some(stability)));
            let here = marks
                .iter()
                .filter(|mark| mark.after.clamp(1, most) == count);
            vertices.extend(here.map(|mark| (mark.at, None)));
        }
        self.stretches(&vertices);
        self.marks.extend(marks);
    }

    /// Draws each stretch in the style of its stability; what lies between special points of one step
    /// is drawn like what comes after.
    fn stretches(&mut self, vertices: &[Vertex]) {
        let mut curve: Option<(Stability, Vec<[f64; 2]>)> = None;
        for (i, pair) in vertices.windows(2).enumerate() {
            let [(from, stability), (to, next)] = [pair[0], pair[1]];
            let later = || vertices[i + 1..].iter().find_map(|vertex| vertex.1);
            let after_point = stability.filter(|_| next.is_none());
            let Some(style) = after_point.or_else(later).or(stability) else {
                continue;
            };
            match &mut curve {
                Some((of, points)) if *of == style => points.push(to),
                _ => {
                    self.draw(curve.take());
                    curve = Some((style, vec![from, to]));
                }
            }
        }
        self.draw(curve);
    }

    fn draw(&mut self, curve: Option<(Stability, Vec<[f64; 2]>)>) {
        if let Some((stability, points)) = curve {
            let series = match stability {
                Stability::Stable => 0,
                Stability::Unstable => 1,
                Stability::Undecided => 3,
            };
            self.panel
                .curves
                .push(Curve::line(stability.name(), series, points));
        }
    }

    /// The panel with its special points, a legend entry for each kind.
    pub(super) fn panel(self) -> Panel {
        let mut panel = self.panel;
        let mut kinds: Vec<Kind> = Vec::new();
        for mark in &self.marks {
            if !kinds.contains(&mark.kind) {
                kinds.push(mark.kind);
            }
        }
        for (i, kind) in kinds.into_iter().enumerate() {
            let of_kind = || self.marks.iter().filter(|mark| mark.kind == kind);
            let labels: Vec<&str> = of_kind().map(|mark| mark.label.as_str()).collect();
            let marker = match kind {
                Kind::Fold => Marker::Circle,
                Kind::Flip => Marker::Cross,
                _ => Marker::Diamond,
            };
            let points = of_kind().map(|mark| mark.at).collect();
            let label = format!("{} ({kind})", labels.join(", "));
            panel
                .curves
                .push(Curve::points(label, 2 + 2 * i, marker, points));
        }
        panel
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_style_changes_at_the_special_point() {
        use Stability::{Stable, Unstable};
        let mut chart = Chart::new(Panel::new(Axis::new("r"), Axis::new("x")));
        let points = [(0.0, Stable), (1.0, Unstable), (2.0, Unstable)]
            .map(|(r, stability)| ([r, r], stability));
        let flip = Mark {
            kind: Kind::Flip,
            label: "PD1".to_owned(),
            after: 1,
            at: [0.5, 0.5],
        };
        chart.add(points.to_vec(), vec![flip]);
        let panel = chart.panel();
        assert_eq!(panel.curves[0].points, [[0.0, 0.0], [0.5, 0.5]]);
        assert_eq!(panel.curves[1].points, [[0.5, 0.5], [1.0, 1.0], [2.0, 2.0]]);
        assert_eq!(panel.curves[2].label, "PD1 (flip)");
    }
}
