//! Branches whose points are read off the unknowns one by one.

use nalgebra::DVector;

use super::ZeroProblem;
use super::branch::{Branch, Started};
use super::crossing::Crossing;
use super::ending::{Ending, Lost};
use super::kind::Kind;
use super::located::Located;
use super::monitor::Monitor;
use super::path::{Border, Watched};
use super::point::Point;
use super::range::Stop;
use crate::field::Work;

/// What the points of a branch are read as, what is looked for among them, and where it ends.
pub trait Reader: Clone {
    /// The problem that is followed.
    type Problem: ZeroProblem + Clone;
    /// Its points.
    type Point: Watched;

    /// A converged point with all that is told of it; `work` is what it has cost.
    fn read(
        &self,
        problem: &Self::Problem,
        point: &Point<<Self::Problem as ZeroProblem>::Extra>,
        work: Work,
    ) -> Self::Point;

    /// A point between two others, the chord between these being a unit vector.
    fn between(
        &self,
        problem: &Self::Problem,
        point: &Point<<Self::Problem as ZeroProblem>::Extra>,
        _chord: &DVector<f64>,
    ) -> Self::Point {
        self.read(problem, point, Work::default())
    }

    /// Share of the accuracy of the points to which what lies between them is evaluated.
    const SHARPER: f64 = 1.0;

    /// Evaluates what lies between two points to this share of their accuracy.
    fn sharpen(&self, _problem: &mut Self::Problem, _share: f64) {}

    /// What is looked for.
    fn monitors(&self) -> Vec<Monitor<'_, Self::Point>>;

    /// Whether r itself measures the way between two points: a branch may bend back over its chord.
    fn straight(&self, _ends: [&Self::Point; 2]) -> bool {
        false
    }

    /// Whether a point after these is none of the branch any more, or one of what it was before, so that the step to it is
    /// taken back.
    fn strays(
        &self,
        _problem: &Self::Problem,
        _points: &[Self::Point],
        _point: &Self::Point,
    ) -> bool {
        false
    }

    /// The point between two others at which a symmetry is lost that both have, found where the branch is not singular for it,
    /// and the errors of r there and of how long it lasts.
    fn lost_between(
        &self,
        _problem: &Self::Problem,
        _ends: [&Self::Point; 2],
    ) -> Option<(Self::Point, [f64; 2])> {
        None
    }

    /// Looks at a special point once more.
    fn refine(&self, _problem: &Self::Problem, _found: &mut Located<Self::Point>) {}

    /// Whether the step from the first of these points to the second has gone, at this special point, from the branch of the
    /// first to one that crosses it there.
    fn leaves(
        &self,
        _problem: &Self::Problem,
        _found: &Located<Self::Point>,
        _ends: [&Self::Point; 2],
    ) -> bool {
        false
    }

    /// The special point that these points lead to, where no step succeeds any more.
    fn explain(&self, _points: &[Self::Point]) -> Option<Located<Self::Point>> {
        None
    }

    /// The special point that these points lead to, the next one being that of a shorter orbit.
    fn falls(&self, _points: &[Self::Point]) -> Option<Located<Self::Point>> {
        None
    }

    /// The point to which a branch comes after these, the next one being refused for this reason; `None` if it is none.
    fn refused(
        &self,
        _branch: &Branch<Self::Problem>,
        _points: &[Self::Point],
        _why: &ErrorOf<Self>,
    ) -> Option<Crossing<Self::Problem, Self::Point>> {
        None
    }

    /// The point at which its equations become others that a branch comes to after these points, and what continues it
    /// there; `None` if it comes to none.
    fn cross(
        &self,
        _branch: &Branch<Self::Problem>,
        _points: &[Self::Point],
    ) -> Option<Crossing<Self::Problem, Self::Point>> {
        None
    }

    /// The same where steps still succeed, and would go on doing so ever more slowly.
    fn leads(
        &self,
        _branch: &Branch<Self::Problem>,
        _points: &[Self::Point],
    ) -> Option<Crossing<Self::Problem, Self::Point>> {
        None
    }

    /// The point between two others at which the equations become others, and what it is.
    fn border(
        &self,
        _problem: &mut Self::Problem,
        _ends: [&Self::Point; 2],
        _r_scale: f64,
    ) -> Option<Border<Self::Point>> {
        None
    }

    /// What that is, of two points as near to it as they can be found, where it is no point that can be found.
    fn name(&self, _problem: &Self::Problem, _ends: [&Self::Point; 2]) -> Kind {
        Kind::VanishingSegment
    }

    /// Why the branch ends with the last of these points, if it does.
    fn ends(
        &self,
        _branch: &Branch<Self::Problem>,
        _points: &[Self::Point],
    ) -> Option<Ending<ErrorOf<Self>>> {
        None
    }

    /// Whether such branches turn at special points only.
    const TURNS_AT_FOLDS: bool = false;

    /// Whether such branches may come round to where they began.
    const CLOSES: bool = false;

    /// Whether a point is the one with which the branch began.
    fn closes(&self, _first: &Self::Point, _back: &Self::Point) -> bool {
        false
    }

    /// How a point is not what was followed, if it is that no more.
    fn lost(&self, _point: &Self::Point) -> Option<Lost> {
        None
    }

    /// Whether a special point beyond which there is no branch is a point of it.
    const ENDS_ON_POINTS: bool = true;

    /// Work of all evaluations.
    fn work(problem: &Self::Problem) -> Work;
}

/// Why a point cannot be evaluated.
pub type ErrorOf<R> = <<R as Reader>::Problem as ZeroProblem>::Error;
/// What a branch comes to where it is not smooth.
pub(super) type CrossingOf<R> = Crossing<<R as Reader>::Problem, <R as Reader>::Point>;

/// A branch under way, its points read by `R`; an iterator over them.
pub struct Reading<R: Reader> {
    /// What reads it.
    pub(super) reader: R,
    pub(super) branch: Branch<R::Problem>,
    first: Option<R::Point>,
    /// Whether its points are evaluated as sharply as what lies between them.
    sharp: bool,
    /// To what share of the values of what is followed special points are located.
    pub(super) accuracy: f64,
    /// Work on the branches before this one.
    spent: Work,
    counted: Work,
}

impl<R: Reader> Reading<R> {
    /// Reads a branch of which the first point has been found; special points are located to `accuracy`, relative to the
    /// values of what is followed.
    pub fn new(reader: R, (branch, first): Started<R::Problem>, accuracy: f64) -> Self {
        let mut reading = Self {
            reader,
            branch,
            first: None,
            sharp: false,
            accuracy,
            spent: Work::default(),
            counted: Work::default(),
        };
        reading.first = Some(reading.read(&first));
        reading
    }

    /// The point from which the branch sets out, until it has been taken.
    #[must_use]
    pub fn first(&self) -> Option<&R::Point> {
        self.first.as_ref()
    }

    /// Why there is no next point.
    #[must_use]
    pub fn stop(&self) -> Option<&Stop<ErrorOf<R>>> {
        self.branch.stop()
    }

    /// What was spent on its points, without what was spent between them.
    pub(super) fn work(&self) -> Work {
        let mut work = self.spent;
        work += R::work(&self.branch.problem);
        work
    }

    /// Evaluates its points more sharply and tries once more, as their errors may be what no step is small enough for; false
    /// if that has been done.
    pub(super) fn sharpen(&mut self) -> bool {
        if self.sharp {
            return false;
        }
        self.sharp = true;
        self.reader.sharpen(&mut self.branch.problem, R::SHARPER);
        self.branch.resume();
        true
    }

    /// Goes on with another branch, its first point next, or the end of its range if that lies before it.
    pub(super) fn go_on(&mut self, (mut branch, first): Started<R::Problem>) {
        self.spent = self.work();
        let first = branch.back_in_range().unwrap_or(first);
        (self.branch, self.sharp) = (branch, false);
        self.first = Some(self.read(&first));
    }

    fn read(&mut self, point: &Point<<R::Problem as ZeroProblem>::Extra>) -> R::Point {
        let total = self.work();
        let work = total.since(&self.counted);
        self.counted = total;
        self.reader.read(&self.branch.problem, point, work)
    }
}

impl<R: Reader> Iterator for Reading<R> {
    type Item = R::Point;

    fn next(&mut self) -> Option<R::Point> {
        if let Some(first) = self.first.take() {
            return Some(first);
        }
        let point = self.branch.next()?;
        Some(self.read(&point))
    }
}
