//! Branches whose points are read off the unknowns one by one.

use super::ZeroProblem;
use super::branch::{Branch, Started};
use super::corrector::Failure;
use super::detect::Monitors;
use super::link::Link;
use super::path::{Path, Watched};
use super::point::Point;
use super::range::{Settings, Stop};
use super::walk::{Counted, Followed};
use crate::field::Work;

/// What the points of a branch are read as, and what is looked for among them.
pub trait Reader: Clone {
    /// The problem that is followed.
    type Problem: ZeroProblem + Clone;
    /// Its points.
    type Point: Watched;

    /// A converged point with all that is told of it.
    fn read(
        &self,
        problem: &Self::Problem,
        point: &Point<<Self::Problem as ZeroProblem>::Extra>,
    ) -> Self::Point;

    /// What is looked for.
    fn monitors(&self) -> Monitors<'_, Self::Point>;

    /// Whether r itself measures the way between two points: a branch may bend back over its chord.
    fn straight(&self, _ends: [&Self::Point; 2]) -> bool {
        false
    }

    /// How far a point is from what was followed, if it is that no more.
    fn lost(&self, _point: &Self::Point) -> Option<f64> {
        None
    }

    /// Work of all evaluations.
    fn work(problem: &Self::Problem) -> Work;
}

/// A branch under way, its points read by `R`.
pub struct Reading<R: Reader> {
    /// What reads it.
    pub reader: R,
    branch: Branch<R::Problem>,
    first: Option<Point<<R::Problem as ZeroProblem>::Extra>>,
    accuracy: f64,
}

impl<R: Reader> Reading<R> {
    /// Reads a branch of which the first point has been found.
    pub fn new(reader: R, (branch, first): Started<R::Problem>, settings: Settings) -> Self {
        Self {
            reader,
            branch,
            first: Some(first),
            accuracy: settings.accuracy,
        }
    }

    /// What was spent on its points, without what was spent between them.
    #[must_use]
    pub fn work(&self) -> Work {
        R::work(&self.branch.problem)
    }
}

impl<R: Reader> Followed for Reading<R> {
    type Point = R::Point;
    type Error = <R::Problem as ZeroProblem>::Error;
    type Path = Between<R>;

    fn step(&mut self) -> Option<R::Point> {
        let point = self.first.take().or_else(|| self.branch.next())?;
        Some(self.reader.read(&self.branch.problem, &point))
    }

    fn stop(&self) -> Option<&Stop<Self::Error>> {
        self.branch.stop()
    }

    fn retract(&mut self) -> bool {
        self.branch.retract()
    }

    fn path(&self, ends: [&R::Point; 2]) -> Option<Between<R>> {
        let link = self.branch.link()?.clone();
        Some(Between {
            counted: R::work(&link.problem),
            straight: self.reader.straight(ends),
            reader: self.reader.clone(),
            link,
        })
    }

    fn monitors(&self) -> Monitors<'_, R::Point> {
        self.reader.monitors()
    }

    fn accuracy(&self) -> f64 {
        self.accuracy
    }

    fn lost(&self, point: &R::Point) -> Option<f64> {
        self.reader.lost(point)
    }
}

/// What lies between two neighbouring points.
pub struct Between<R: Reader> {
    reader: R,
    link: Link<R::Problem>,
    straight: bool,
    counted: Work,
}

impl<R: Reader> Path for Between<R> {
    type Point = R::Point;
    type Error = Failure<<R::Problem as ZeroProblem>::Error>;

    fn at(&mut self, share: f64) -> Result<R::Point, Self::Error> {
        let level = self.straight.then(|| self.link.level(share).ok());
        let point = match level.flatten() {
            Some(point) => point,
            None => self.link.between(share)?,
        };
        Ok(self.reader.read(&self.link.problem, &point))
    }
}

impl<R: Reader> Counted for Between<R> {
    fn work(&self) -> Work {
        R::work(&self.link.problem).since(&self.counted)
    }
}
