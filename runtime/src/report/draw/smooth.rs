//! Smooth lines through places: cubics, of known directions where there are any.

use super::vector::{Vector, angle, difference, dot, length, unit};
use crate::report::text::number;

/// Places nearer to each other than this, px, are one.
const SAME: f64 = 1e-3;
/// The cosine of a turn that is a corner.
const CORNER: f64 = 0.5;
/// Chords of which one is so many times longer than the other show even this turn to be a corner: its tangent would bend the
/// longer one.
const UNEVEN: f64 = 4.0;
const SLIGHT: f64 = 0.9995;
/// The cosine of the angle to its chord from which on a tangent counts less, and the least share that it keeps.
const ASIDE: f64 = 0.5;
const LEAST: f64 = 0.2;

/// By how much of its chord a motion with the rates at both ends may miss it: more, and they are those of a layer between.
const ASTRAY: f64 = 0.5;
/// By how much more than the line turns at a place its known direction there may differ from what is seen, rad.
const DOUBT: f64 = 0.05;

/// A place of a line, and its directions there as it comes and as it goes on, if they are known; of a motion they are its
/// rates, and it is known when it comes and goes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Knot {
    pub(super) place: Vector,
    pub(super) directions: [Option<Vector>; 2],
    pub(super) times: [Option<f64>; 2],
}

/// A smooth line through these, with gaps where there is no place.
pub(super) fn smooth(knots: &[Knot]) -> String {
    let runs = knots.split(|knot| !knot.place.iter().all(|at| at.is_finite()));
    runs.map(run).collect()
}

fn run(knots: &[Knot]) -> String {
    let mut distinct: Vec<Knot> = Vec::new();
    for knot in knots {
        match distinct.last_mut() {
            Some(last) if length(difference(knot.place, last.place)) < SAME => {
                last.directions[1] = knot.directions[1];
                last.times[1] = knot.times[1];
            }
            _ => distinct.push(*knot),
        }
    }
    let [first, _, ..] = distinct.as_slice() else {
        return String::new();
    };
    let headings = headings(&distinct);
    let [x, y] = first.place.map(number);
    let mut path = format!("M{x} {y}");
    for (pair, heading) in distinct.windows(2).zip(headings.windows(2)) {
        let ends = [pair[0].place, pair[1].place];
        let handles = moved([&pair[0], &pair[1]]);
        path += &cubic(
            ends,
            handles.unwrap_or_else(|| held(ends, [heading[0][1], heading[1][0]])),
        );
    }
    path
}

/// What a cubic between two knots has for handles if it is the motion itself, to fourth order: Hermite's; nothing where its
/// rates are not known, or do not lead from one knot to the other.
fn moved([from, to]: [&Knot; 2]) -> Option<[Vector; 2]> {
    let time = to.times[0]? - from.times[1]?;
    let rates = [from.directions[1]?, to.directions[0]?];
    let chord = difference(to.place, from.place);
    let way = [0, 1].map(|k| 0.5 * time * (rates[0][k] + rates[1][k]));
    let leads = time > 0.0 && length(difference(way, chord)) <= ASTRAY * length(chord);
    leads.then(|| rates.map(|rate| rate.map(|part| part * time / 3.0)))
}

/// The handles of a cubic between two places with these unit tangents, without loops.
fn held([from, to]: [Vector; 2], tangents: [Vector; 2]) -> [Vector; 2] {
    let chord = difference(to, from);
    let handle = |tangent: Vector| {
        let along = dot(tangent, chord) / length(chord);
        length(chord) / 3.0 * (along / ASIDE).clamp(LEAST, 1.0)
    };
    tangents.map(|tangent| tangent.map(|part| part * handle(tangent)))
}

fn cubic([from, to]: [Vector; 2], [a, b]: [Vector; 2]) -> String {
    let places = [
        [from[0] + a[0], from[1] + a[1]],
        [to[0] - b[0], to[1] - b[1]],
        to,
    ];
    let [a, b, to] = places.map(|[x, y]| format!("{} {}", number(x), number(y)));
    format!("C{a} {b} {to}")
}

/// The unit tangents before and after each place: two where there is a corner.
fn headings(knots: &[Knot]) -> Vec<[Vector; 2]> {
    let last = knots.len() - 1;
    let chords: Vec<Vector> = knots
        .windows(2)
        .map(|pair| difference(pair[1].place, pair[0].place))
        .collect();
    let inner = |i: usize| between(chords[i - 1], chords[i], knots[i].directions);
    let mut all = vec![[unit(chords[0]); 2]; last + 1];
    for i in 1..last {
        all[i] = inner(i);
    }
    let begin = end(chords[0], all[1][0], knots[0].directions[1], last > 1);
    all[0] = [begin; 2];
    let before = all[last - 1][1];
    let finish = end(
        chords[last - 1],
        before,
        knots[last].directions[0],
        last > 1,
    );
    all[last] = [finish; 2];
    all
}

/// The tangents between two chords: where only one side is known, the other one is straight.
fn between(before: Vector, after: Vector, known: [Option<Vector>; 2]) -> [Vector; 2] {
    let weights = [length(after), length(before)];
    let [from, to] = [unit(before), unit(after)];
    // The tangent of the parabola, its parameter being the length of the chords.
    let parabola = [0, 1].map(|k| weights[0] * from[k] + weights[1] * to[k]);
    let ratio = weights[0] / weights[1];
    let straight = if ratio.max(1.0 / ratio) > UNEVEN {
        SLIGHT
    } else {
        CORNER
    };
    match known {
        [None, None] if dot(from, to) < straight => [from, to],
        [None, None] => [unit(parabola); 2],
        [Some(one), Some(other)] if one == other => {
            let known = towards(one, parabola);
            // A rate in a thin layer magnifies every error of a state: what its neighbours contradict is not believed.
            let believed = angle(known, unit(parabola)) <= angle(from, to) + DOUBT;
            [if believed { known } else { unit(parabola) }; 2]
        }
        [one, other] => [
            one.map_or(from, |one| towards(one, from)),
            other.map_or(to, |other| towards(other, to)),
        ],
    }
}

/// The tangent at an end whose only chord has `inner` at its other side.
fn end(chord: Vector, inner: Vector, known: Option<Vector>, bends: bool) -> Vector {
    let straight = unit(chord);
    if let Some(known) = known {
        return towards(known, straight);
    }
    if !bends {
        return straight;
    }
    unit([0, 1].map(|k| 2.0 * straight[k] - inner[k]))
}

/// A known direction, turned to where the line goes.
fn towards(known: Vector, way: Vector) -> Vector {
    let known = unit(known);
    if dot(known, way) < 0.0 {
        known.map(|part| -part)
    } else {
        known
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(places: &[Vector]) -> Vec<f64> {
        let knot = |&place: &Vector| Knot {
            place,
            directions: [None; 2],
            times: [None; 2],
        };
        numbers(&smooth(&places.iter().map(knot).collect::<Vec<_>>()))
    }

    fn numbers(path: &str) -> Vec<f64> {
        let words = path.split(['M', 'C', ' ']).filter(|word| !word.is_empty());
        words.map(|word| word.parse().unwrap()).collect()
    }

    /// The middle of each cubic of a path.
    fn middles(path: &[f64]) -> Vec<Vector> {
        let ends = (0..path.len() / 6).map(|i| &path[6 * i..6 * i + 8]);
        let middle = |p: &[f64], k| (p[k] + 3.0 * (p[k + 2] + p[k + 4]) + p[k + 6]) / 8.0;
        ends.map(|p| [middle(p, 0), middle(p, 1)]).collect()
    }

    #[test]
    fn a_circle_is_drawn_through_few_points() {
        let places: Vec<Vector> = (0..=12)
            .map(|i| (f64::from(i) * std::f64::consts::TAU / 12.0).sin_cos())
            .map(|(sin, cos)| [200.0 * cos, 200.0 * sin])
            .collect();
        let inner = &middles(&line(&places))[1..11];
        let off = inner.iter().map(|at| (length(*at) - 200.0).abs());
        assert!(off.fold(0.0, f64::max) < 0.2);
        // A polygon would be off by as much as the height of its arcs.
        assert!(200.0 * (1.0 - (std::f64::consts::TAU / 24.0).cos()) > 6.0);
    }

    #[test]
    fn known_directions_are_kept() {
        let knot = |x: f64| Knot {
            place: [x, x * x * x / 100.0],
            directions: [Some([-1.0, -3.0 * x * x / 100.0]); 2],
            times: [None; 2],
        };
        let path = numbers(&smooth(&[knot(0.0), knot(5.0), knot(10.0)]));
        assert_eq!(path[3], 0.0, "level at 0");
        for [x, y] in middles(&path) {
            // A polygon would be off by seven times as much.
            assert!((y - x * x * x / 100.0).abs() < 0.2, "{x} {y}");
        }
    }

    #[test]
    fn a_motion_is_drawn_as_it_moves() {
        // A parabola thrown far aside of its chord: of degree two in time, and so exact.
        let knot = |t: f64| Knot {
            place: [900.0 * (1.0 - t * t), 10.0 * t],
            directions: [Some([-1800.0 * t, 10.0]); 2],
            times: [Some(t); 2],
        };
        let path = numbers(&smooth(&[knot(-1.0), knot(1.0)]));
        assert_eq!(middles(&path), [[900.0, 0.0]]);
        // Rates that lead elsewhere are those of a layer, and only their directions count.
        let late = Knot {
            times: [Some(9.0); 2],
            ..knot(1.0)
        };
        let path = numbers(&smooth(&[knot(-1.0), late]));
        assert!(middles(&path)[0][0] < 20.0);
    }

    #[test]
    fn a_corner_stays_a_corner() {
        let path = line(&[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0]]);
        assert_eq!(middles(&path), [[5.0, 0.0], [10.0, 5.0]]);
    }

    #[test]
    fn a_place_said_twice_has_a_direction_for_each_side() {
        let knot = |x: f64, direction: Vector| Knot {
            place: [x, 0.0],
            directions: [Some(direction), Some(direction)],
            times: [None; 2],
        };
        let (up, down) = ([1.0, 1.0], [1.0, -1.0]);
        let knots = [
            knot(0.0, up),
            knot(9.0, down),
            knot(9.0, up),
            knot(18.0, down),
        ];
        let path = numbers(&smooth(&knots));
        // Two humps that meet in a corner.
        assert_eq!(path[..8], [0.0, 0.0, 2.12, 2.12, 6.88, 2.12, 9.0, 0.0]);
        assert_eq!(path[8..], [11.12, 2.12, 15.88, 2.12, 18.0, 0.0]);
    }

    #[test]
    fn a_direction_that_its_neighbours_contradict_is_not_believed() {
        let knot = |x: f64, slope: f64| Knot {
            place: [x, 0.0],
            directions: [Some([1.0, slope]); 2],
            times: [None; 2],
        };
        let path = |slope| {
            numbers(&smooth(&[
                knot(0.0, 0.0),
                knot(9.0, slope),
                knot(18.0, 0.0),
            ]))
        };
        assert_eq!(path(0.3)[5], 0.0);
        assert!(path(0.04)[5] != 0.0);
    }

    #[test]
    fn any_places_make_a_path() {
        for places in [
            &[][..],
            &[[1.0, 1.0]],
            &[[1.0, 1.0], [1.0, 1.0]],
            &[[f64::NAN, 0.0], [1.0, 1.0], [f64::INFINITY, 0.0]],
        ] {
            assert!(line(places).is_empty());
        }
    }
}
