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

/// A point of a branch to be drawn.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point {
    /// The design variable, and the value shown.
    pub(super) at: [f64; 2],
    /// What tells, besides the design variable, where on the branch a special point lies.
    pub(super) beside: f64,
    pub(super) stability: Stability,
}

/// A special point to be drawn.
#[derive(Debug, Clone)]
pub(super) struct Mark {
    pub(super) kind: Kind,
    pub(super) label: String,
    pub(super) at: [f64; 2],
    pub(super) beside: f64,
}

/// Where a stretch passes, and what is known of the stability there.
#[derive(Clone, Copy)]
struct Vertex {
    at: [f64; 2],
    stability: Option<Stability>,
}

impl Mark {
    /// Between which points it lies: the number of the one before it, and the share of the way to the next. It is the
    /// place between neighbours that the design variable lies between, and where the other value fits best.
    fn place(&self, points: &[Point]) -> (usize, f64) {
        let [r, value] = [self.at[0], self.beside];
        let mut best = (f64::INFINITY, (0, 0.0));
        for (after, pair) in points.windows(2).enumerate() {
            let [from, to] = [&pair[0], &pair[1]].map(|point| [point.at[0], point.beside]);
            let width = to[0] - from[0];
            let share = if width == 0.0 {
                0.0
            } else {
                ((r - from[0]) / width).clamp(0.0, 1.0)
            };
            let between = |column: usize| from[column] + share * (to[column] - from[column]);
            let off = (between(0) - r).abs() / r.abs().max(f64::MIN_POSITIVE)
                + (between(1) - value).abs() / value.abs().max(f64::MIN_POSITIVE);
            if off < best.0 {
                best = (off, (after, share));
            }
        }
        best.1
    }
}

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
    pub(super) fn add(&mut self, points: &[Point], marks: Vec<Mark>) {
        let places: Vec<_> = marks.iter().map(|mark| mark.place(points)).collect();
        let mut vertices: Vec<Vertex> = Vec::new();
        for (i, point) in points.iter().enumerate() {
            vertices.push(Vertex {
                at: point.at,
                stability: Some(point.stability),
            });
            let mut here: Vec<(f64, [f64; 2])> = places
                .iter()
                .zip(&marks)
                .filter(|((after, _), _)| *after == i)
                .map(|((_, share), mark)| (*share, mark.at))
                .collect();
            here.sort_by(|a, b| a.0.total_cmp(&b.0));
            vertices.extend(here.iter().map(|(_, at)| Vertex {
                at: *at,
                stability: None,
            }));
        }
        self.stretches(&vertices);
        self.marks.extend(marks);
    }

    /// Draws each stretch in the style of its stability; what lies between special points of one step
    /// is drawn like what comes after.
    fn stretches(&mut self, vertices: &[Vertex]) {
        let mut curve: Option<(Stability, Vec<[f64; 2]>)> = None;
        for (i, pair) in vertices.windows(2).enumerate() {
            let later = || vertices[i + 1..].iter().find_map(|vertex| vertex.stability);
            let after_point = pair[0].stability.filter(|_| pair[1].stability.is_none());
            let Some(style) = after_point.or_else(later).or(pair[0].stability) else {
                continue;
            };
            match &mut curve {
                Some((of, points)) if *of == style => points.push(pair[1].at),
                _ => {
                    self.draw(curve.take());
                    curve = Some((style, vec![pair[0].at, pair[1].at]));
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

    fn point(r: f64, beside: f64, shown: f64, stability: Stability) -> Point {
        Point {
            at: [r, shown],
            beside,
            stability,
        }
    }

    fn flip(r: f64, beside: f64, shown: f64) -> Mark {
        Mark {
            kind: Kind::Flip,
            label: "PD1".to_owned(),
            at: [r, shown],
            beside,
        }
    }

    #[test]
    fn a_special_point_lies_where_both_values_fit() {
        // Through a fold at r = 2: r = 1.5 is passed twice, with different periods.
        let points = [[1.0, 10.0, 0.1], [2.0, 20.0, 0.2], [1.0, 30.0, 0.3]]
            .map(|[r, period, shown]| point(r, period, shown, Stability::Stable));
        let (after, share) = flip(1.5, 25.0, 0.25).place(&points);
        assert_eq!(after, 1);
        assert!((share - 0.5).abs() < 1e-15);
    }

    #[test]
    fn the_style_changes_at_the_special_point() {
        use Stability::{Stable, Unstable};
        let mut chart = Chart::new(Panel::new(Axis::new("r"), Axis::new("x")));
        let points = [(0.0, Stable), (1.0, Unstable), (2.0, Unstable)]
            .map(|(r, stability)| point(r, r, r, stability));
        chart.add(&points, vec![flip(0.5, 0.5, 0.5)]);
        let panel = chart.panel();
        assert_eq!(panel.curves[0].points, [[0.0, 0.0], [0.5, 0.5]]);
        assert_eq!(panel.curves[1].points, [[0.5, 0.5], [1.0, 1.0], [2.0, 2.0]]);
        assert_eq!(panel.curves[2].label, "PD1 (flip)");
    }
}
