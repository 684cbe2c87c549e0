//! A branch: what its points are against what was followed, stable and unstable, with its special points.

use super::super::text::{followed, timed};
use super::axis;
use crate::bifurcation::Stability;
use crate::field::Design;
use crate::model::ModelInfo;
use crate::report::{Axis, Curve, Figure, Marker, Panel};
use crate::study::{Along, BranchRecord, EquilibriaRecord};

/// A point of a branch to be drawn: r, the value, and what is known of its stability.
#[derive(Clone, Copy)]
struct Vertex {
    at: [f64; 2],
    stability: Option<Stability>,
}

/// A special point to be drawn.
struct Mark {
    kind: &'static str,
    label: String,
    at: [f64; 2],
}

/// A branch of orbits, with those that leave it: the extent of the first state, and the period.
pub(in crate::app) fn branch(info: &ModelInfo, branch: &BranchRecord) -> Figure {
    let parameter = parameter(info, &branch.along);
    let first = info.states.first();
    let name = format!("max |{}|", first.map_or("", |state| state.name));
    let extent = Panel::new(
        parameter.clone(),
        axis(&name, first.and_then(|state| state.unit)),
    );
    let period = Panel::new(parameter, Axis::new(&timed(info, "period", "s")));
    let (mut extents, mut periods) = (Chart::new(extent), Chart::new(period));
    for one in branch.all() {
        let orbits = || {
            one.points
                .iter()
                .filter_map(|orbit| Some((orbit.r?, orbit)))
        };
        let rows: Vec<[f64; 3]> = orbits()
            .map(|(r, orbit)| {
                [
                    r,
                    orbit.period,
                    orbit.max_abs.first().copied().unwrap_or(0.0),
                ]
            })
            .collect();
        let stability: Vec<Stability> =
            orbits().map(|(_, orbit)| orbit.floquet.stability).collect();
        let places: Vec<Place> = one
            .special
            .iter()
            .map(|special| Place::on(&rows, [special.r, special.period]))
            .collect();
        for (chart, column) in [(&mut extents, 2), (&mut periods, 1)] {
            let points: Vec<[f64; 2]> = rows.iter().map(|row| [row[0], row[column]]).collect();
            let marks = one.special.iter().map(|special| Mark {
                kind: special.kind,
                label: special.label.clone(),
                at: match column {
                    1 => [special.r, special.period],
                    _ => [special.r, special.max_abs.first().copied().unwrap_or(0.0)],
                },
            });
            chart.add(&points, &stability, &places, marks.collect());
        }
    }
    Figure::new("", info.name, String::new())
        .columns(2)
        .panel(extents.panel())
        .panel(periods.panel())
}

/// A branch of equilibria: the first state.
pub(in crate::app) fn equilibria(info: &ModelInfo, branch: &EquilibriaRecord) -> Figure {
    let first = info.states.first();
    let name = first.map_or("", |state| state.name);
    let y = axis(name, first.and_then(|state| state.unit));
    let mut chart = Chart::new(Panel::new(parameter(info, &branch.along), y));
    let value = |state: &[f64]| state.first().copied().unwrap_or(0.0);
    let rows: Vec<[f64; 3]> = branch
        .points
        .iter()
        .filter_map(|point| Some([point.r?, value(&point.state), value(&point.state)]))
        .collect();
    let points: Vec<[f64; 2]> = rows.iter().map(|row| [row[0], row[1]]).collect();
    let stability: Vec<Stability> = branch.points.iter().map(|point| point.stability).collect();
    let special = |one: &crate::study::SpecialEquilibrium| [one.r, value(&one.state)];
    let places: Vec<Place> = branch
        .special
        .iter()
        .map(|one| Place::on(&rows, special(one)))
        .collect();
    let marks = branch.special.iter().map(|one| Mark {
        kind: one.kind,
        label: one.label.clone(),
        at: special(one),
    });
    chart.add(&points, &stability, &places, marks.collect());
    Figure::new("", info.name, String::new()).panel(chart.panel())
}

/// The axis of what is followed: a size of smoothing by its logarithm.
fn parameter(info: &ModelInfo, along: &Along) -> Axis {
    let axis = Axis::new(&followed(info, along));
    if along.design == Design::Smoothing {
        axis.logarithmic()
    } else {
        axis
    }
}

/// Where between two points of a branch a special one lies.
struct Place {
    /// Number of the point before it.
    after: usize,
    share: f64,
}

impl Place {
    /// The place between neighbours that r lies between, and where the other value fits best.
    fn on(rows: &[[f64; 3]], [r, value]: [f64; 2]) -> Self {
        let mut best = (
            f64::INFINITY,
            Self {
                after: 0,
                share: 0.0,
            },
        );
        for (after, pair) in rows.windows(2).enumerate() {
            let [from, to] = [pair[0], pair[1]];
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
                best = (off, Self { after, share });
            }
        }
        best.1
    }
}

/// A panel that gathers stretches of equal stability and special points of equal kind.
struct Chart {
    panel: Panel,
    marks: Vec<Mark>,
}

impl Chart {
    const fn new(panel: Panel) -> Self {
        Self {
            panel,
            marks: Vec::new(),
        }
    }

    fn add(
        &mut self,
        points: &[[f64; 2]],
        stability: &[Stability],
        places: &[Place],
        marks: Vec<Mark>,
    ) {
        let mut vertices: Vec<Vertex> = Vec::new();
        for (i, (at, stability)) in points.iter().zip(stability).enumerate() {
            vertices.push(Vertex {
                at: *at,
                stability: Some(*stability),
            });
            let mut here: Vec<(f64, [f64; 2])> = places
                .iter()
                .zip(&marks)
                .filter(|(place, _)| place.after == i)
                .map(|(place, mark)| (place.share, mark.at))
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
    fn panel(self) -> Panel {
        let mut panel = self.panel;
        let mut kinds: Vec<&str> = Vec::new();
        for mark in &self.marks {
            if !kinds.contains(&mark.kind) {
                kinds.push(mark.kind);
            }
        }
        for (i, kind) in kinds.into_iter().enumerate() {
            let of_kind = || self.marks.iter().filter(|mark| mark.kind == kind);
            let labels: Vec<&str> = of_kind().map(|mark| mark.label.as_str()).collect();
            let marker = match kind {
                "fold" => Marker::Circle,
                "flip" => Marker::Cross,
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
    fn a_special_point_lies_where_both_values_fit() {
        // Through a fold at r = 2: r = 1.5 is passed twice, with different periods.
        let rows = [[1.0, 10.0, 0.1], [2.0, 20.0, 0.2], [1.0, 30.0, 0.3]];
        let place = Place::on(&rows, [1.5, 25.0]);
        assert_eq!(place.after, 1);
        assert!((place.share - 0.5).abs() < 1e-15);
    }

    #[test]
    fn the_style_changes_at_the_special_point() {
        use Stability::{Stable, Unstable};
        let mut chart = Chart::new(Panel::new(Axis::new("r"), Axis::new("x")));
        let points = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]];
        let place = Place {
            after: 0,
            share: 0.5,
        };
        let mark = Mark {
            kind: "flip",
            label: "PD1".to_owned(),
            at: [0.5, 0.5],
        };
        chart.add(&points, &[Stable, Unstable, Unstable], &[place], vec![mark]);
        let panel = chart.panel();
        assert_eq!(panel.curves[0].points, [[0.0, 0.0], [0.5, 0.5]]);
        assert_eq!(panel.curves[1].points, [[0.5, 0.5], [1.0, 1.0], [2.0, 2.0]]);
        assert_eq!(panel.curves[2].label, "PD1 (flip)");
    }
}
