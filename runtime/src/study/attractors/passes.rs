//! Where a branch passes a value of its design variable.

use crate::motion::Modes;
use crate::shooting::{Orbit, OrbitError, Search, closest};
use crate::study::branch::BranchRecord;
use crate::study::orbit::Sought;

/// Between two points a branch keeps to what they span, and to this share of it beyond: it bends.
const BEYOND: f64 = 0.5;
/// Share of their values that is added to what two points span.
const SLACK: f64 = 1e-6;

/// A place of a branch: an orbit of it, or a special point.
#[derive(Clone, Copy)]
struct Vertex<'a> {
    r: f64,
    period: f64,
    max_abs: &'a [f64],
    state: &'a [f64],
    modes: &'a Modes,
}

/// The places of a branch in their order.
pub(super) struct Passes<'a>(Vec<Vertex<'a>>);

/// From where an orbit of a branch is looked for.
pub(super) struct Guess<'a> {
    state: &'a [f64],
    modes: &'a Modes,
    period: f64,
}

impl<'a> Passes<'a> {
    pub(super) fn of(branch: &'a BranchRecord) -> Self {
        let mut vertices = Vec::with_capacity(branch.points.len() + branch.special.len() + 1);
        for count in 0..=branch.points.len() {
            let special = branch.special.iter().filter(|one| one.after == count);
            // Where a doubled branch ends, the orbit is gone around twice.
            vertices.extend(special.map(|one| Vertex {
                r: one.r,
                period: one.turns as f64 * one.period,
                max_abs: &one.max_abs,
                state: &one.state,
                modes: &one.modes,
            }));
            vertices.extend(branch.points.get(count).and_then(|one| {
                Some(Vertex {
                    r: one.r?,
                    period: one.period,
                    max_abs: &one.max_abs,
                    state: &one.state,
                    modes: &one.modes,
                })
            }));
        }
        if branch.ended.is_closed() {
            vertices.extend(vertices.first().copied());
        }
        Self(vertices)
    }

    /// Both ends of each stretch that passes `r` where an orbit as large and as long as this one may lie on it, the nearer
    /// end first.
    pub(super) fn near(&self, orbit: &Orbit, r: f64) -> Vec<Guess<'a>> {
        let max_abs = orbit.max_abs();
        let passes = |ends: &&[Vertex<'_>]| {
            let within = |a: f64, b: f64, y: f64| {
                let slack = BEYOND * (b - a).abs() + SLACK * y.abs();
                a.min(b) - slack <= y && y <= a.max(b) + slack
            };
            let [a, b] = [&ends[0], &ends[1]];
            let sizes = a.max_abs.iter().zip(b.max_abs).zip(&max_abs);
            (a.r - r) * (b.r - r) <= 0.0
                && within(a.period, b.period, orbit.period)
                && sizes.into_iter().all(|((a, b), y)| within(*a, *b, *y))
        };
        let guesses = self.0.windows(2).filter(passes).flat_map(|ends| {
            let mut ends = [ends[0], ends[1]];
            ends.sort_by(|a, b| (a.r - r).abs().total_cmp(&(b.r - r).abs()));
            ends
        });
        let guess = |end: Vertex<'a>| Guess {
            state: end.state,
            modes: end.modes,
            period: end.period,
        };
        guesses.map(guess).collect()
    }
}

impl Sought<'_> {
    /// The orbit at r to which Newton leads from a guess.
    pub(super) fn from(&self, guess: Guess<'_>, r: f64) -> Result<Orbit, OrbitError> {
        let search = Search {
            start: guess.state.to_vec(),
            modes: guess.modes.clone(),
            period: Some(guess.period),
            ..self.search.clone()
        };
        closest(&self.family, r, &search)
    }
}
