//! One walk along a branch: it watches, locates what happens, accounts for every change, and ends.

use std::ops::ControlFlow;

use super::between::Between;
use super::branch::Started;
use super::detect::detect;
use super::ending::Ending;
use super::kind::Kind;
use super::located::{Findings, Located, Unexplained, drop_pairs};
use super::path::Watched;
use super::range::{Settings, Stop};
use super::reading::{ErrorOf, Reader, Reading};
use crate::field::Work;

/// A step so short, in scaled coordinates, that what it passes is looked for at once.
const SHORT: f64 = 1e-2;

/// A branch that has been walked along.
#[derive(Debug, Clone)]
pub struct Walked<P, E> {
    /// Its points in the order in which they were found.
    pub points: Vec<P>,
    /// What happens on it, in the same order.
    pub located: Vec<Located<P>>,
    /// Why it ended.
    pub ending: Ending<E>,
    /// What was spent between its points.
    pub searched: Work,
}

/// Walks along a branch from its first point to its end, and tells what that has cost; `watch` sees each point as it is
/// found, and may end the branch there.
pub fn follow<R: Reader>(
    reader: R,
    started: Started<R::Problem>,
    settings: Settings,
    watch: &mut dyn FnMut(&R::Point) -> ControlFlow<()>,
) -> (Walked<R::Point, ErrorOf<R>>, Work) {
    let mut branch = Reading::new(reader, started, settings.accuracy);
    let walked = walk(&mut branch, watch);
    let mut work = branch.work();
    work += walked.searched;
    (walked, work)
}

/// Walks along a branch to its end; `watch` sees each point as it is found, and may end the branch there.
pub fn walk<R: Reader>(
    followed: &mut Reading<R>,
    watch: &mut dyn FnMut(&R::Point) -> ControlFlow<()>,
) -> Walked<R::Point, ErrorOf<R>> {
    let mut walk = Walk::new(followed, false);
    let ending = walk.run(watch);
    if let Ending::Unbounded(r) = ending {
        walk.forget_turns_at(r);
    }
    let unexplained = walk.unexplained.filter(|_| !ending.is_interrupted());
    Walked {
        points: walk.points,
        located: walk.located,
        ending: unexplained.map_or(ending, Ending::Unexplained),
        searched: walk.searched,
    }
}

/// A branch on the way.
pub(super) struct Walk<'a, R: Reader> {
    pub(super) followed: &'a mut Reading<R>,
    pub(super) points: Vec<R::Point>,
    pub(super) located: Vec<Located<R::Point>>,
    unexplained: Option<Unexplained>,
    /// Work on steps that were taken back.
    wasted: Work,
    /// Work between points.
    pub(super) searched: Work,
    /// Whether it only goes back to where the branch is not smooth, and ends there.
    pub(super) returns: bool,
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

impl<'a, R: Reader> Walk<'a, R> {
    pub(super) fn new(followed: &'a mut Reading<R>, returns: bool) -> Self {
        Self {
            followed,
            points: Vec::new(),
            located: Vec::new(),
            unexplained: None,
            wasted: Work::default(),
            searched: Work::default(),
            returns,
        }
    }

    pub(super) fn run(
        &mut self,
        watch: &mut dyn FnMut(&R::Point) -> ControlFlow<()>,
    ) -> Ending<ErrorOf<R>> {
        loop {
            let Some(mut point) = self.followed.next() else {
                match self.stopped() {
                    Some(ending) => return ending,
                    None => continue,
                }
            };
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
            self.note_plateau();
            let Reading { reader, branch, .. } = &*self.followed;
            ending = ending.or_else(|| reader.ends(branch, &self.points));
            if let Some(ending) = ending {
                return ending;
            }
            if verdict.is_break() {
                return Ending::Interrupted;
            }
            let leads = || reader.leads(branch, &self.points);
            let crossing = (!self.returns).then(leads).flatten();
            if let Some(ending) = crossing.and_then(|crossing| self.come_to(crossing)) {
                return ending;
            }
        }
    }

    /// The end of a branch on which there is no next step; `None` if it goes on beyond a point at which it is not smooth.
    fn stopped(&mut self) -> Option<Ending<ErrorOf<R>>> {
        let stop = self.followed.stop().cloned().unwrap_or(Stop::TooManyPoints);
        if matches!(stop, Stop::Creeping(_)) && self.followed.sharpen() {
            return None;
        }
        if !stop.is_stuck() {
            return match self.refused(&stop) {
                Some(crossing) => self.come_to(crossing),
                None => Some(Ending::Stopped(stop)),
            };
        }
        if let Some(crossing) = self.crossing() {
            return self.pass(crossing);
        }
        let reason = self.followed.reader.explain(&self.points);
        let sharper = R::SHARPER < 1.0 && matches!(stop, Stop::StepTooSmall(_));
        if reason.is_none() && sharper && self.followed.sharpen() {
            return None;
        }
        if reason.is_none() && self.followed.branch.turn() {
            return None;
        }
        Some(reason.map_or(Ending::Stopped(stop), |reason| self.end(reason)))
    }

    /// Looks for what happens on the way to `point`, and for the end of the branch before it.
    fn examine(&mut self, point: &mut R::Point) -> Verdict<R::Point, ErrorOf<R>> {
        if let Some(off) = self.followed.reader.lost(point) {
            return Verdict::End(Ending::Lost(off));
        }
        let Some(before) = self.points.last() else {
            return Verdict::GoOn;
        };
        point.inherit(before);
        let Reading { reader, branch, .. } = &*self.followed;
        if reader.strays(&branch.problem, &self.points, point) {
            return self.astray(point);
        }
        let (ends, accuracy) = ([before, &*point], self.followed.accuracy);
        let Some(mut path) = Between::of(self.followed, ends) else {
            return Verdict::GoOn;
        };
        let findings = detect(&mut path, &self.followed.reader.monitors(), ends, accuracy);
        // Around a corner it may come back along r, and no test function says so.
        let corner = self.followed.branch.turned;
        let turns = R::TURNS_AT_FOLDS && !corner && findings.turns_unseen(ends);
        let link = self.followed.branch.link();
        let short = link.is_some_and(|link| link.length() <= SHORT);
        let bends = !short && (findings.bends(point) || path.leapt());
        if !findings.unexplained.is_empty() || findings.runs_back(point) || turns || bends {
            // Beyond a border, what was found need not be the same motion any more.
            let crossing = if short { self.crossing() } else { None };
            let seen = crossing.map(|crossing| {
                let way = self.on_the_way(&findings, &crossing.located);
                (crossing, way)
            });
            let told = seen
                .as_ref()
                .is_some_and(|(crossing, way)| self.accounts(way, &crossing.located));
            if !told && self.followed.branch.retract() {
                self.wasted += path.work();
                self.wasted += point.work().copied().unwrap_or_default();
                return Verdict::Again;
            }
            if let Some((crossing, way)) = seen {
                self.keep(way);
                return self.pass(crossing).map_or(Verdict::Again, Verdict::End);
            }
        }
        let round = self.round(&mut path, ends);
        self.searched += path.work();
        if let Some(work) = point.work() {
            *work += path.work();
            *work += std::mem::take(&mut self.wasted);
        }
        self.note(findings, round, point)
    }

    /// Where the branch was last as sure of its directions as at this point, if it has not been since: what passes may have
    /// passed all along from there.
    fn sure_until(&self, point: &R::Point) -> Option<f64> {
        let unsure = |one: &&R::Point| one.marginal() > point.marginal();
        self.points.last().filter(unsure)?;
        let sure = self.points.iter().rev().find(|one| !unsure(one));
        sure.map(Watched::r)
    }

    /// Keeps what was found on a step to this point, unless that has left the branch there.
    fn note(
        &mut self,
        mut findings: Findings<R::Point>,
        round: Option<Ending<ErrorOf<R>>>,
        point: &mut R::Point,
    ) -> Verdict<R::Point, ErrorOf<R>> {
        let Reading { reader, branch, .. } = &*self.followed;
        let (after, before) = (self.points.len(), self.points.last());
        let sure = self.sure_until(point);
        let left = |found: &mut Located<R::Point>| {
            found.after = after;
            reader.refine(&branch.problem, found);
            if let (Some(r), Some(2)) = (sure, found.kind.jump()) {
                found.error = found.error.max((found.r - r).abs());
            }
            before.is_some_and(|before| reader.leaves(&branch.problem, found, [before, &*point]))
        };
        let left = findings
            .located
            .iter_mut()
            .map(left)
            .fold(false, |any, one| any | one);
        if left && self.followed.branch.retract() {
            self.wasted += point.work().copied().unwrap_or_default();
            return Verdict::Again;
        }
        let reader = &self.followed.reader;
        if let Some(last) = findings.located.last_mut().filter(|event| event.last)
            && let Some(met) = reader.explain(&self.points)
            && met.kind == last.kind
            && (met.r - last.r).abs() > met.error
        {
            // So near to where branches meet a multiplier says less than what the points lead to.
            (last.r, last.error) = (met.r, met.error);
        }
        let first = findings.unexplained.into_iter().next();
        let last = findings.located.last().filter(|event| event.last).cloned();
        self.located.extend(findings.located);
        drop_pairs(&mut self.located);
        match (last, findings.bound) {
            (Some(last), _) if R::ENDS_ON_POINTS => {
                return Verdict::Last(last.point, Ending::At(last.kind, last.r));
            }
            (Some(last), _) if last.kind == Kind::Flip => {
                return Verdict::End(Ending::Meets(last.kind, last.r));
            }
            (Some(last), _) => return Verdict::End(Ending::At(last.kind, last.r)),
            (None, Some(bound)) => return Verdict::Last(bound, Ending::Left),
            (None, None) => {}
        }
        self.unexplained = self.unexplained.take().or(first);
        round.map_or(Verdict::GoOn, Verdict::End)
    }

    /// What was found belongs to another branch: the step went past where they meet.
    fn astray(&mut self, point: &mut R::Point) -> Verdict<R::Point, ErrorOf<R>> {
        if self.followed.branch.retract() {
            self.wasted += point.work().copied().unwrap_or_default();
            Verdict::Again
        } else {
            let reason = self.followed.reader.explain(&self.points);
            if reason.is_none()
                && let Some(crossing) = self.crossing()
            {
                return self.pass(crossing).map_or(Verdict::Again, Verdict::End);
            }
            let reason = reason.or_else(|| self.followed.reader.falls(&self.points));
            let ending = reason.map(|reason| self.end(reason));
            Verdict::End(ending.unwrap_or(Ending::FallsBack(point.r())))
        }
    }
}
