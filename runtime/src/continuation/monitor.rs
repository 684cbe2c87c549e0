//! Named functions of the points of a branch that change sign where something happens.

use super::kind::Kind;

/// Share of itself that a function changes by over a step in which it does not vanish and come back.
const STILL: f64 = 0.05;

/// What the zero of a monitor means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// A special point.
    Special(Kind),
    /// A special point beyond which the branch is none any more.
    Last(Kind),
    /// The branch leaves what was asked for.
    Bound,
}

type Test<'a, P> = Box<dyn Fn(&P) -> f64 + 'a>;
type Applies<'a, P> = Box<dyn Fn([&P; 2]) -> bool + 'a>;
type Mark<'a, P> = Box<dyn Fn(&mut P) + 'a>;
type Judge<'a, P> = Box<dyn Fn([&P; 2], &P) -> Option<Verdict> + 'a>;

/// A function of a point that changes sign where something happens.
pub struct Monitor<'a, P> {
    pub(super) test: Test<'a, P>,
    pub(super) rounding: Test<'a, P>,
    applies: Applies<'a, P>,
    steady: Applies<'a, P>,
    judge: Judge<'a, P>,
    mark: Mark<'a, P>,
}

impl<'a, P> Monitor<'a, P> {
    /// The monitor of a special point: `test` changes its sign there; NaN where it has no value.
    pub fn new(kind: Kind, test: impl Fn(&P) -> f64 + 'a) -> Self {
        Self {
            test: Box::new(test),
            rounding: Box::new(|_| 0.0),
            applies: Box::new(|_| true),
            steady: Box::new(|_| false),
            judge: Box::new(move |_, _| Some(Verdict::Special(kind))),
            mark: Box::new(|_| {}),
        }
    }

    /// The same, where the two points between which it changes sign allow it.
    #[must_use]
    pub fn only_if(mut self, applies: impl Fn([&P; 2]) -> bool + 'a) -> Self {
        self.applies = Box::new(applies);
        self
    }

    /// The same, which does not vanish and come back between two points of which something else tells so.
    #[must_use]
    pub fn steady_if(mut self, steady: impl Fn([&P; 2]) -> bool + 'a) -> Self {
        self.steady = Box::new(steady);
        self
    }

    /// The same, with what is told by the points beside the zero and by the point at it; `None` if nothing happens there.
    #[must_use]
    pub fn judged(mut self, judge: impl Fn([&P; 2], &P) -> Option<Verdict> + 'a) -> Self {
        self.judge = Box::new(judge);
        self
    }

    /// The same, where rounding leaves this much of its value uncertain.
    #[must_use]
    pub fn known_to(mut self, rounding: impl Fn(&P) -> f64 + 'a) -> Self {
        self.rounding = Box::new(rounding);
        self
    }

    /// The same, where the point at the zero is told of it.
    #[must_use]
    pub fn marked(mut self, mark: impl Fn(&mut P) + 'a) -> Self {
        self.mark = Box::new(mark);
        self
    }

    /// Whether it changes sign between two points, and counts there.
    pub(super) fn crosses(&self, ends: [&P; 2]) -> bool {
        let [from, to] = ends.map(&self.test);
        changes(from, to) && (self.applies)(ends)
    }

    /// Whether it does not vanish and come back between two points, as far as they tell.
    pub(super) fn rests(&self, ends: [&P; 2]) -> bool {
        rests(ends.map(&self.test)) || (self.steady)(ends)
    }

    pub(super) fn verdict(&self, ends: [&P; 2], at: &mut P) -> Option<Verdict> {
        (self.mark)(at);
        (self.judge)(ends, at)
    }
}

/// Whether a value hardly changes, as far as it has one.
#[must_use]
pub fn rests([a, b]: [f64; 2]) -> bool {
    let change = (b - a).abs();
    change.is_nan() || change <= STILL * a.abs().min(b.abs())
}

/// Whether two values lie on different sides of 0. A point may lie on the zero itself: 0 has a sign like any number, so
/// that one of the steps beside it sees it.
#[must_use]
pub fn changes(from: f64, to: f64) -> bool {
    !(from.is_nan() || to.is_nan()) && (from < 0.0) != (to < 0.0)
}

/// Whether the parabola through three values, the outer ones of one sign, passes zero between them.
pub(super) fn dips([a, m, b]: [f64; 3]) -> bool {
    let sign = if a < 0.0 || b < 0.0 { -1.0 } else { 1.0 };
    let [a, m, b] = [a, m, b].map(|value| sign * value);
    let (slope, bend) = (0.5 * (b - a), 0.5 * (a + b) - m);
    let inside = bend > 0.0 && slope.abs() < 2.0 * bend;
    let least = if inside {
        m - slope * slope / (4.0 * bend)
    } else {
        m
    };
    least < 0.0
}
