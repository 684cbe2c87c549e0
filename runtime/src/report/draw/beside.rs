//! Words beside points: where they hide no marker, no other word, and as little of the lines as can be.

use super::curve::MARKER;
use super::element::{path, words};
use super::view::View;
use crate::report::curve::{Curve, Shape};
use crate::report::figure::Panel;
use crate::report::text::{number, width};

/// The size of the words, px.
const TEXT: f64 = 11.0;
/// Markers nearer to each other than this, px, share their words.
const NEAR: f64 = 5.0;
/// More labels of one place are counted only.
const MOST: usize = 3;
/// Distances from a marker to its words that are tried, px; from the second on a stroke leads there.
const DISTANCES: [f64; 6] = [3.0, 12.0, 22.0, 34.0, 50.0, 70.0];
/// Ways from a marker that are tried: right above first.
const WAYS: [[f64; 2]; 12] = [
    [0.71, -0.71],
    [-0.71, -0.71],
    [0.71, 0.71],
    [-0.71, 0.71],
    [1.0, 0.0],
    [-1.0, 0.0],
    [0.0, -1.0],
    [0.0, 1.0],
    [0.92, -0.38],
    [-0.92, -0.38],
    [0.92, 0.38],
    [-0.92, 0.38],
];
/// What a hidden marker or word costs, and what a hidden piece of a line, beside a step outwards.
const HIDDEN: f64 = 50.0;
const CROSSED: f64 = 0.4;
/// Length of the pieces in which lines are looked at, px.
const PIECE: f64 = 3.0;

/// Left, top, right, bottom.
type Area = [f64; 4];

/// Words for a place.
struct Note {
    place: [f64; 2],
    labels: Vec<String>,
}

/// The words beside all points of a panel that have any.
pub(super) fn draw(panel: &Panel, frame: &View) -> String {
    let notes = notes(panel, frame);
    if notes.is_empty() {
        return String::new();
    }
    let mut taken = markers(panel, frame);
    let lines = lines(panel, frame);
    let mut out = String::new();
    for note in &notes {
        let text = note.text();
        let Some((area, leads)) = free(note.place, &text, frame, &taken, &lines) else {
            continue;
        };
        taken.push(area);
        if leads {
            let ends = [note.place, nearest(note.place, area)];
            let [from, to] = ends.map(|[x, y]| format!("{} {}", number(x), number(y)));
            out += &path(
                &format!("M{from}L{to}"),
                r##"stroke="#808080" stroke-width="0.5""##,
            );
        }
        out += &words(&text, [area[0], area[3] - 0.2 * TEXT], TEXT, "start");
    }
    out
}

impl Note {
    fn text(&self) -> String {
        let shown = self.labels.iter().take(MOST).cloned().collect::<Vec<_>>();
        match self.labels.len().saturating_sub(MOST) {
            0 => shown.join(", "),
            more => format!("{}, +{more}", shown.join(", ")),
        }
    }
}

/// What there is to say; markers that lie on each other share their words.
fn notes(panel: &Panel, frame: &View) -> Vec<Note> {
    let mut notes: Vec<Note> = Vec::new();
    for curve in &panel.curves {
        for (point, label) in curve.points.iter().zip(&curve.labels) {
            let place = frame.place(*point);
            if label.is_empty() || !frame.holds(place) {
                continue;
            }
            let here = |note: &&mut Note| distance(note.place, place) < NEAR;
            match notes.iter_mut().find(here) {
                Some(note) => note.labels.push(label.clone()),
                None => notes.push(Note {
                    place,
                    labels: vec![label.clone()],
                }),
            }
        }
    }
    notes
}

fn markers(panel: &Panel, frame: &View) -> Vec<Area> {
    let marked = |curve: &&Curve| matches!(curve.shape, Shape::Points(_));
    let points = panel.curves.iter().filter(marked);
    let places = points.flat_map(|curve| curve.points.iter().map(|point| frame.place(*point)));
    let area = |[x, y]: [f64; 2]| [x - MARKER, y - MARKER, x + MARKER, y + MARKER];
    places.map(area).collect()
}

/// Places along all lines, close to each other.
fn lines(panel: &Panel, frame: &View) -> Vec<[f64; 2]> {
    let drawn = |curve: &&Curve| !matches!(curve.shape, Shape::Points(_));
    let mut all = Vec::new();
    for curve in panel.curves.iter().filter(drawn) {
        let places: Vec<[f64; 2]> = curve.points.iter().map(|p| frame.place(*p)).collect();
        for pair in places.windows(2) {
            let pieces = (distance(pair[0], pair[1]) / PIECE).ceil().min(500.0);
            let at = |share: f64| [0, 1].map(|k| pair[0][k] + share * (pair[1][k] - pair[0][k]));
            let shares = (0..pieces as usize).map(|i| i as f64 / pieces);
            all.extend(shares.map(at).filter(|place| frame.holds(*place)));
        }
    }
    all
}

/// The best place for words, and whether they are so far away that a stroke must lead there; none if nothing fits in.
fn free(
    place: [f64; 2],
    text: &str,
    frame: &View,
    taken: &[Area],
    lines: &[[f64; 2]],
) -> Option<(Area, bool)> {
    let size = [TEXT * width(text) + 2.0, TEXT];
    let candidates = DISTANCES.iter().enumerate().flat_map(|(step, far)| {
        let ways = WAYS.iter().enumerate();
        ways.map(move |(way, towards)| {
            let cost = 4.0 * step as f64 + 0.1 * way as f64;
            (area(place, *towards, *far, size), cost, step > 0)
        })
    });
    let cost = |area: &Area| {
        let hidden = taken.iter().filter(|other| overlap(area, other)).count();
        let crossed = lines.iter().filter(|at| within(area, **at)).count();
        HIDDEN * hidden as f64 + CROSSED * crossed as f64
    };
    let inside = candidates.filter(|([left, top, right, bottom], ..)| {
        frame.holds([*left, *top]) && frame.holds([*right, *bottom])
    });
    let all = inside.map(|(area, far, leads)| (far + cost(&area), area, leads));
    let best = all.min_by(|a, b| a.0.total_cmp(&b.0))?;
    Some((best.1, best.2))
}

/// Words of this size at a distance from a marker.
fn area([x, y]: [f64; 2], [right, down]: [f64; 2], far: f64, [wide, high]: [f64; 2]) -> Area {
    let away = MARKER + far;
    let middle = [
        x + right * away + right.signum() * 0.5 * wide * f64::from(right.abs() > 0.3),
        y + down * (away + 0.5 * high),
    ];
    let [left, top] = [middle[0] - 0.5 * wide, middle[1] - 0.5 * high];
    [left, top, left + wide, top + high]
}

fn nearest([x, y]: [f64; 2], [left, top, right, bottom]: Area) -> [f64; 2] {
    [x.clamp(left, right), y.clamp(top, bottom)]
}

fn overlap(a: &Area, b: &Area) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

fn within([left, top, right, bottom]: &Area, [x, y]: [f64; 2]) -> bool {
    (*left..*right).contains(&x) && (*top..*bottom).contains(&y)
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
