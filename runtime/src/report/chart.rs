//! A branch drawn: stable and unstable stretches, with its special points.

pub use super::special::{Mark, special_points};
use super::{Curve, Panel};
use crate::bifurcation::{Kind, Stability};
use crate::study::{BranchRecord, OrbitRecord, Special};

/// A point of a branch to be drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// The design variable with the value shown.
    pub at: [f64; 2],
    /// The direction of the branch there, of any length, where it is known.
    pub direction: Option<[f64; 2]>,
    /// Its stability.
    pub stability: Stability,
}

/// A branch to be drawn.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Drawn {
    /// Its points in their order.
    pub points: Vec<Point>,
    /// Its special points in the same order.
    pub marks: Vec<Mark>,
    /// Where it leaves another, which marks that point.
    pub root: Option<Mark>,
    /// Whether it comes back to its first point.
    pub closed: bool,
}

/// Where a branch passes, and what is known of it there.
#[derive(Debug, Clone, Copy)]
struct Vertex {
    at: [f64; 2],
    direction: Option<[f64; 2]>,
    stability: Option<Stability>,
    kind: Option<Kind>,
}

/// A panel that gathers stretches of equal stability and special points of equal kind.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    panel: Panel,
    marks: Vec<Mark>,
}

impl Chart {
    /// A chart in a panel that has its axes.
    pub const fn new(panel: Panel) -> Self {
        Self {
            panel,
            marks: Vec::new(),
        }
    }

    /// Adds a branch.
    pub fn add(&mut self, branch: Drawn) {
        self.stretches(&branch.vertices());
        self.marks
            .extend(branch.marks.into_iter().filter(|mark| mark.shown));
    }

    /// Draws each stretch in the style of its stability, up to where that changes, or the branch has a corner; what lies
    /// between special points of one step is drawn like what comes after.
    fn stretches(&mut self, vertices: &[Vertex]) {
        let mut stretch: Option<(Stability, usize)> = None;
        for i in 0..vertices.len().saturating_sub(1) {
            let here = vertices[i].stability;
            let later = || vertices[i + 1..].iter().find_map(|vertex| vertex.stability);
            let before_mark = here.filter(|_| vertices[i + 1].stability.is_none());
            let Some(style) = before_mark.or_else(later).or(here) else {
                continue;
            };
            let goes_on = |(of, _): &(Stability, usize)| *of == style && !vertices[i].is_corner();
            if !stretch.as_ref().is_some_and(goes_on)
                && let Some((of, from)) = stretch.replace((style, i))
            {
                self.draw(of, vertices, [from, i]);
            }
        }
        if let Some((of, from)) = stretch {
            self.draw(of, vertices, [from, vertices.len() - 1]);
        }
    }

    fn draw(&mut self, stability: Stability, vertices: &[Vertex], [from, to]: [usize; 2]) {
        let series = match stability {
            Stability::Stable => 0,
            Stability::Unstable => 1,
            Stability::Undecided => 3,
        };
        let points = vertices[from..=to].iter().map(|vertex| vertex.at).collect();
        let directions = (from..=to).map(|i| direction(vertices, i)).collect();
        let curve = Curve::smooth(stability.name(), series, points).directed(directions);
        self.panel.curves.push(curve);
    }

    /// The panel with its special points.
    pub fn panel(self) -> Panel {
        self.panel.curves(special_points(self.marks))
    }
}

impl Drawn {
    /// A quantity of the orbits of branch number `number`, and of its special points; labels of others than the first say
    /// of which branch they are.
    #[must_use]
    pub fn of(
        (number, branch): (usize, &BranchRecord),
        mut of: impl FnMut(&OrbitRecord) -> Option<f64>,
        special: impl Fn(&Special) -> f64,
    ) -> Self {
        let mark = |one: &Special| Mark {
            kind: one.kind,
            label: match number {
                0 => one.label.clone(),
                _ => format!("{number}:{}", one.label),
            },
            after: one.after,
            at: [one.r, special(one)],
            shown: true,
        };
        let seen = |mark: &Mark| mark.at[1].is_finite();
        let points = branch.points.iter().map(|one| {
            let (at, direction) = placed(one, &mut of);
            Point {
                at,
                direction,
                stability: one.floquet.stability,
            }
        });
        Self {
            points: points.collect(),
            marks: branch.special.iter().map(mark).filter(seen).collect(),
            root: branch.root.as_ref().map(mark).filter(seen),
            closed: branch.ended.is_closed(),
        }
    }

    /// What the branch passes, in its order.
    fn vertices(&self) -> Vec<Vertex> {
        let mut vertices = Vec::new();
        for count in 0..=self.points.len() {
            let root = self.root.iter().filter(|root| root.after == count);
            let marks = self.marks.iter().filter(|mark| mark.after == count);
            vertices.extend(root.chain(marks).map(Vertex::special));
            vertices.extend(self.points.get(count).map(Vertex::plain));
        }
        if self.closed {
            vertices.extend(self.points.first().map(Vertex::plain));
        }
        vertices
    }
}

impl Vertex {
    fn plain(point: &Point) -> Self {
        Self {
            at: point.at,
            direction: point.direction,
            stability: Some(point.stability),
            kind: None,
        }
    }

    fn special(mark: &Mark) -> Self {
        Self {
            at: mark.at,
            direction: None,
            stability: None,
            kind: Some(mark.kind),
        }
    }

    /// Whether a branch may have a corner there: where orbits touch what they have not met before.
    fn is_corner(&self) -> bool {
        self.kind
            .is_some_and(|kind| kind.is_border() || kind == Kind::BoundaryEquilibrium)
    }
}

/// Where a quantity of an orbit is drawn over the design variable, and the direction of its branch there if that is known.
pub fn placed(
    orbit: &OrbitRecord,
    mut of: impl FnMut(&OrbitRecord) -> Option<f64>,
) -> ([f64; 2], Option<[f64; 2]>) {
    let mut place = |orbit: &OrbitRecord| {
        let r = orbit.r.unwrap_or(f64::NAN);
        [r, of(orbit).unwrap_or(f64::NAN)]
    };
    let at = place(orbit);
    let further = orbit.further().map(|further| place(&further));
    let direction = further.map(|to| [to[0] - at[0], to[1] - at[1]]);
    (
        at,
        direction.filter(|way| way.iter().all(|part| part.is_finite())),
    )
}

/// The direction of a branch at a vertex; NaN where it is left to be seen from the stretch alone.
fn direction(vertices: &[Vertex], i: usize) -> [f64; 2] {
    let unknown = [f64::NAN; 2];
    let here = &vertices[i];
    if let Some(known) = here.direction {
        return known;
    }
    match here.kind {
        Some(Kind::Fold) => return [0.0, 1.0],
        _ if here.is_corner() => return unknown,
        _ => {}
    }
    let (Some(before), Some(after)) = (i.checked_sub(1), vertices.get(i + 1)) else {
        return unknown;
    };
    let before = &vertices[before];
    // The parabola through three points over the design variable; where the branch turns, it is none.
    let [from, to] = [before, after].map(|other| {
        let step = other.at[0] - here.at[0];
        (step, (other.at[1] - here.at[1]) / step)
    });
    if from.0 * to.0 >= 0.0 {
        return unknown;
    }
    [1.0, (from.1 * to.0 - to.1 * from.0) / (to.0 - from.0)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::Axis;

    fn chart(branch: Drawn) -> Panel {
        let mut chart = Chart::new(Panel::new(Axis::new("r"), Axis::new("x")));
        chart.add(branch);
        chart.panel()
    }

    fn point(r: f64, stability: Stability) -> Point {
        Point {
            at: [r, r],
            direction: None,
            stability,
        }
    }

    fn mark(kind: Kind, after: usize, at: [f64; 2]) -> Mark {
        let label = format!("{}1", kind.letters());
        Mark {
            kind,
            label,
            after,
            at,
            shown: true,
        }
    }

    #[test]
    fn the_style_changes_at_the_special_point() {
        use Stability::{Stable, Unstable};
        let points = [(0.0, Stable), (1.0, Unstable), (2.0, Unstable)]
            .map(|(r, stability)| point(r, stability));
        let panel = chart(Drawn {
            points: points.to_vec(),
            marks: vec![mark(Kind::Flip, 1, [0.5, 0.5])],
            ..Drawn::default()
        });
        assert_eq!(panel.curves[0].points, [[0.0, 0.0], [0.5, 0.5]]);
        assert_eq!(panel.curves[1].points, [[0.5, 0.5], [1.0, 1.0], [2.0, 2.0]]);
        assert_eq!(panel.curves[1].directions[0], [1.0, 1.0]);
        assert_eq!(panel.curves[2].label, "flip (PD)");
        assert_eq!(panel.curves[2].labels, ["PD1"]);
    }

    #[test]
    fn a_branch_goes_from_its_root_to_its_last_special_point() {
        let panel = chart(Drawn {
            points: vec![point(1.0, Stability::Stable)],
            marks: vec![mark(Kind::Flip, 1, [2.0, 2.0])],
            root: Some(mark(Kind::Flip, 0, [0.0, 0.0])),
            closed: false,
        });
        assert_eq!(panel.curves[0].points, [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]);
        assert_eq!(panel.curves[1].points.len(), 1, "its parent marks the root");
    }
}
