//! What lies between two neighbouring points of a branch, as far as those who look need to know.

use std::fmt::Display;

use super::kind::Kind;
use crate::field::Work;

/// A point of a branch as it is read off the unknowns.
pub trait Watched: Clone {
    /// The design variable.
    fn r(&self) -> f64;

    /// What its branch measures r in: r itself, but not where that is next to nothing.
    fn r_scale(&self) -> f64;

    /// What errors of r are measured in: r itself, or, as far as that is more and its branch measures r in it, what it takes to
    /// change the unknowns by their own magnitude. Along a canard that is nothing.
    fn r_size(&self) -> f64 {
        let slope = self.slope().abs();
        let effect = slope / (1.0 - slope * slope).max(0.0).sqrt();
        self.r().abs().max(self.r_scale() * effect.min(1.0))
    }

    /// r-component of the unit tangent of the branch.
    fn slope(&self) -> f64;

    /// How far it is from another point, relative to the values of what is followed.
    fn moved(&self, from: &Self) -> f64 {
        ((self.r() - from.r()) / self.r()).abs()
    }

    /// The number of unstable directions.
    fn unstable(&self) -> usize {
        0
    }

    /// The number of directions that are neither stable nor unstable as far as their errors tell; `None` if no change of
    /// these numbers asks for a reason.
    fn marginal(&self) -> Option<usize> {
        None
    }

    /// The number of unstable directions beside those that pass at a special point of this kind, if this is one; `None`
    /// where that is not known.
    fn growing_beside(&self, _kind: Kind) -> Option<usize> {
        None
    }

    /// Takes from the point before on its branch what it cannot tell itself.
    fn inherit(&mut self, _before: &Self) {}

    /// What it has cost, if that is told of each point.
    fn work(&mut self) -> Option<&mut Work> {
        None
    }

    /// Whether both lie in one regime: what lies between two regimes is not smooth.
    fn same_regime(&self, _other: &Self) -> bool {
        true
    }

    /// The same as far as the errors of both tell.
    fn seems_in_regime_of(&self, other: &Self) -> bool {
        self.same_regime(other)
    }

    /// The time between the two events that happen in the other order in the regime of `other`, if that is all by which
    /// they differ; zero, if they happen at once here and one after the other there.
    fn exchanged(&self, _other: &Self) -> Option<f64> {
        None
    }

    /// How long the stretch lasts that is all by which it differs from the regime of `other`, which is without it.
    fn besides(&self, _other: &Self) -> Option<f64> {
        None
    }

    /// By how much it is not in another regime: numbers that are positive, and fall to zero where one of these happens or
    /// ceases to; counted as in another point of its regime, none beside one of another.
    fn margins(&self, _as_in: &Self) -> Vec<(Chance, f64)> {
        Vec::new()
    }

    /// How long what is followed takes: its events are known to the accuracy times this.
    fn lasts(&self) -> f64 {
        0.0
    }
}

/// What may happen or cease to, so that a regime ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Chance {
    /// An event of this contact, which does not happen.
    Event(usize),
    /// The event that ends the stretch of this number, which might go out otherwise.
    Outcome(usize),
    /// The stretch of this number, which might vanish.
    Stretch(usize),
}

/// The branch between two neighbouring points.
pub trait Path {
    /// Its points.
    type Point: Watched;
    /// Why one could not be found.
    type Error: Display;

    /// The point at a share of the way, 0 < share < 1.
    ///
    /// # Errors
    /// No point could be found there.
    fn at(&mut self, share: f64) -> Result<Self::Point, Self::Error>;

    /// About what lies at a share of the way, as cheaply as may be; `None` where that cannot be told.
    fn glance(&mut self, _share: f64) -> Option<Self::Point> {
        None
    }

    /// The point at a share of the way once more, more sharply or else less; `None` where neither can be done.
    fn again(&mut self, _share: f64) -> Option<Self::Point> {
        None
    }

    /// The point between two others at which their regimes part, if it can be found as a point of its own.
    fn border(&mut self, _ends: [&Self::Point; 2]) -> Option<Border<Self::Point>> {
        None
    }

    /// The point between two others at which a symmetry is lost that both have, the errors of r there and of how long it lasts: the
    /// branch is singular there.
    fn lost_between(&mut self, _ends: [&Self::Point; 2]) -> Option<(Self::Point, [f64; 2])> {
        None
    }

    /// r of the point at which the branch turns at once between the points at these shares of the way, and its error; `None` where
    /// that cannot be told.
    fn corner(&mut self, _shares: [f64; 2]) -> Option<(f64, f64)> {
        None
    }

    /// What the change between two points is called that are as near to it as they can be found, if it could not be found
    /// as a point of its own: two events exchange their order, or a stretch begins between them.
    fn name(&mut self, _ends: [&Self::Point; 2]) -> Kind {
        Kind::VanishingSegment
    }
}

/// A point between two regimes, found as a point of its own.
#[derive(Debug, Clone)]
pub struct Border<P> {
    /// What happens there.
    pub kind: Kind,
    /// The point, as it is come to and as it is left.
    pub points: [P; 2],
    /// Its place, as a share of the way between the two points between which it was found.
    pub share: f64,
    /// Estimated error of r there.
    pub error: f64,
    /// Whether nothing continues the branch beyond.
    pub last: bool,
}

/// A point and its place on a path.
#[derive(Debug, Clone)]
pub struct Spot<P> {
    /// Its share of the way.
    pub share: f64,
    /// The point.
    pub point: P,
}

impl<P: Clone> Spot<P> {
    pub(super) fn new(share: f64, point: &P) -> Self {
        Self {
            share,
            point: point.clone(),
        }
    }
}
