//! One walk along a branch: it watches, locates what happens, accounts for every change, and ends.

use std::ops::ControlFlow;

use super::detect::{Monitors, detect};
use super::ending::Ending;
use super::located::{Findings, Located, Unexplained};
use super::path::{Path, Watched};
use super::range::Stop;
use super::root::reach;
use crate::field::Work;

/// Points after which a branch may have come round.
const ROUND: usize = 3;

/// A branch of some kind of motion, point by point, and what is looked for on it.
pub trait Followed {
    /// Its points.
    type Point: Watched;
    /// Why a point cannot be evaluated.
    type Error: std::error::Error + Clone;

    /// The next point; `None` at the end.
    fn step(&mut self) -> Option<Self::Point>;

    /// Why there is no next point.
    fn stop(&self) -> Option<&Stop<Self::Error>>;

    /// Takes the last step back, so that the next one is much shorter; `false` if that is not possible.
    fn retract(&mut self) -> bool;

    /// What lies between two points.
    type Path: Path<Point = Self::Point> + Counted;

    /// What lies between the last two points; `None` at the first.
    fn path(&self) -> Option<Self::Path>;

    /// What is looked for.
    fn monitors(&self) -> Monitors<'_, Self::Point>;

    /// To what share of the values of what is followed special points are located.
    fn accuracy(&self) -> f64;

    /// Whether a point is none of the branch any more, so that the step to it is taken back.
    fn strays(&self, _point: &Self::Point) -> bool {
        false
    }

    /// Looks at a special point once more.
    fn refine(&self, _found: &mut Located<Self::Point>) {}

    /// The special point that these points lead to, where no step succeeds any more.
    fn explain(&self, _points: &[Self::Point]) -> Option<Located<Self::Point>> {
        None
    }

    /// Why the branch ends with the last of these points, if it does.
    fn ends(&self, _points: &[Self::Point]) -> Option<Ending<Self::Error>> {
        None
    }

    /// Whether such branches may come round to where they began.
    const CLOSES: bool = false;

    /// Whether a point is the one with which the branch began.
    fn closes(&self, _first: &Self::Point, _back: &Self::Point) -> bool {
        false
    }

    /// How far a point is from what was followed, if it is that no more.
    fn lost(&self, _point: &Self::Point) -> Option<f64> {
        None
    }

    /// Whether a special point beyond which there is no branch is a point of it.
    const ENDS_ON_POINTS: bool = true;
}

/// A path that counts what is spent on it.
pub trait Counted {
    /// Work of all points found on it.
    fn work(&self) -> Work;
}

/// A branch that has been walked along.
#[derive(Debug, Clone)]
pub struct Walked<P, E> {
    /// Its points in the order in which they were found.
    pub points: Vec<P>,
    /// What happens on it, in the same order.
    pub located: Vec<Located<P>>,
    /// How many of the points precede each of these.
    pub after: Vec<usize>,
    /// Why it ended.
    pub ending: Ending<E>,
    /// What was spent between its points.
    pub searched: Work,
}

/// Walks along a branch to its end; `watch` sees each point as it is found, and may end the branch there.
pub fn walk<F: Followed>(
    followed: &mut F,
    watch: &mut dyn FnMut(&F::Point) -> ControlFlow<()>,
) -> Walked<F::Point, F::Error> {
    let mut walk = Walk {
        followed,
        points: Vec::new(),
        located: Vec::new(),
        after: Vec::new(),
        unexplained: None,
        wasted: Work::default(),
        searched: Work::default(),
    };
    let ending = walk.run(watch);
    let unexplained = walk.unexplained.filter(|_| !ending.is_interrupted());
    Walked {
        points: walk.points,
        located: walk.located,
        after: walk.after,
        ending: unexplained.map_or(ending, Ending::Unexplained),
        searched: walk.searched,
    }
}

/// A branch on the way.
struct Walk<'a, F: Followed> {
    followed: &'a mut F,
    points: Vec<F::Point>,
    located: Vec<Located<F::Point>>,
    after: Vec<usize>,
    unexplained: Option<Unexplained>,
    /// Work on steps that were taken back.
    wasted: Work,
    /// Work between points.
    searched: Work,
}

/// What to do after a step.
enum Verdict<P, E> {
    GoOn,
    /// It was taken back.
    Again,
    /// The branch ends before this point.
    End(Ending<E>),
    /// The branch ends with this point in its place.
    Last(P, Ending<E>),
}

impl<F: Followed> Walk<'_, F> {
    fn run(&mut self, watch: &mut dyn FnMut(&F::Point) -> ControlFlow<()>) -> Ending<F::Error> {
        while let Some(mut point) = self.followed.step() {
            let mut ending = match self.examine(&mut point) {
                Verdict::GoOn => None,
                Verdict::Again => continue,
                Verdict::End(ending) => return ending,
                Verdict::Last(last, ending) => {
                    point = last;
                    Some(ending)
                }
            };
            let verdict = watch(&point);
            self.points.push(point);
            ending = ending.or_else(|| self.followed.ends(&self.points));
            if let Some(ending) = ending {
                return ending;
            }
            if verdict.is_break() {
                return Ending::Interrupted;
            }
        }
        self.stopped()
    }

    /// The end of a branch on which there is no next step.
    fn stopped(&mut self) -> Ending<F::Error> {
        let stop = self.followed.stop().cloned().unwrap_or(Stop::TooManyPoints);
        let reason = match &stop {
            Stop::StepTooSmall(_) | Stop::Creeping(_) => self.followed.explain(&self.points),
            _ => None,
        };
        reason.map_or(Ending::Stopped(stop), |reason| self.end(reason))
    }

    /// Looks for what happens on the way to `point`, and for the end of the branch before it.
    fn examine(&mut self, point: &mut F::Point) -> Verdict<F::Point, F::Error> {
        if let Some(off) = self.followed.lost(point) {
            return Verdict::End(Ending::Lost(off));
        }
        let Some(before) = self.points.last() else {
            return Verdict::GoOn;
        };
        point.inherit(before);
        if self.followed.strays(point) {
            return self.astray(point);
        }
        let Some(mut path) = self.followed.path() else {
            return Verdict::GoOn;
        };
        let (ends, accuracy) = ([before, &*point], self.followed.accuracy());
        let findings = detect(&mut path, &self.followed.monitors(), ends, accuracy);
        if !findings.unexplained.is_empty() {
            // Beyond a graze, what was found is not the same motion any more.
            if let Some(reason) = self.followed.explain(&self.points) {
                return Verdict::End(self.end(reason));
            }
            if self.followed.retract() {
                self.wasted += path.work();
                self.wasted += point.work().copied().unwrap_or_default();
                return Verdict::Again;
            }
        }
        let round = self.round(&mut path, ends);
        self.searched += path.work();
        if let Some(work) = point.work() {
            *work += path.work();
            *work += std::mem::take(&mut self.wasted);
        }
        self.note(findings, round)
    }

    /// Where the branch began, if it has come back there between these points.
    fn round(&self, path: &mut F::Path, ends: [&F::Point; 2]) -> Option<f64> {
        let first = self
            .points
            .first()
            .filter(|_| F::CLOSES && self.points.len() > ROUND)?;
        let back = reach(path, ends, first.r(), self.followed.accuracy()).ok()??;
        self.followed.closes(first, &back).then_some(first.r())
    }

    /// Keeps what was found on a step that is not taken back.
    fn note(
        &mut self,
        mut findings: Findings<F::Point>,
        round: Option<f64>,
    ) -> Verdict<F::Point, F::Error> {
        for found in &mut findings.located {
            self.followed.refine(found);
        }
        let first = findings.unexplained.into_iter().next();
        let last = findings.located.last().filter(|event| event.last).cloned();
        self.located.extend(findings.located);
        self.after.resize(self.located.len(), self.points.len());
        match (last, findings.bound) {
            (Some(last), _) if F::ENDS_ON_POINTS => {
                return Verdict::Last(last.point, Ending::At(last.kind, last.r));
            }
            (Some(last), _) => return Verdict::End(Ending::Meets(last.r)),
            (None, Some(bound)) => return Verdict::Last(bound, Ending::Left),
            (None, None) => {}
        }
        self.unexplained = self.unexplained.take().or(first);
        round.map_or(Verdict::GoOn, |r| Verdict::End(Ending::Closed(r)))
    }

    /// What was found belongs to another branch: the step went past where they meet.
    fn astray(&mut self, point: &mut F::Point) -> Verdict<F::Point, F::Error> {
        if self.followed.retract() {
            self.wasted += point.work().copied().unwrap_or_default();
            Verdict::Again
        } else {
            Verdict::End(Ending::FallsBack(point.r()))
        }
    }

    fn end(&mut self, reason: Located<F::Point>) -> Ending<F::Error> {
        let ending = Ending::At(reason.kind, reason.r);
        self.located.push(reason);
        self.after.push(self.points.len());
        ending
    }
}
