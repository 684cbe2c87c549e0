//! Points of a walk at which the branch is not smooth: what continues it there, and what lies on the way to them.

use super::crossing::{Beyond, Crossing};
use super::detect::explains;
use super::ending::Ending;
use super::kind::Kind;
use super::located::{Findings, Located};
use super::path::Watched;
use super::range::Stop;
use super::reading::{CrossingOf, ErrorOf, Reader, Reading};
use super::walk::Walk;

/// Points that lie between two crossings of one border, and the distance up to which it is one.
const APART: usize = 3;
const SAME: f64 = 1e-7;

impl<R: Reader> Walk<'_, R> {
    /// Goes on beyond a point at which the branch is not smooth, or ends there.
    pub(super) fn pass(
        &mut self,
        Crossing { located, beyond }: CrossingOf<R>,
    ) -> Option<Ending<ErrorOf<R>>> {
        let (kind, r) = (located.kind, located.r);
        let end = self.end(located.clone());
        match beyond {
            _ if self.returns => Some(end),
            Beyond::Nothing => Some(end),
            Beyond::Undecided => Some(Ending::Undecided(kind, r)),
            Beyond::Onwards(started) => {
                self.look_back(&started.0, &located);
                self.followed.go_on(*started);
                None
            }
        }
    }

    /// Ends the branch at a point that it does not pass.
    pub(super) fn end(&mut self, reason: Located<R::Point>) -> Ending<ErrorOf<R>> {
        let ending = if reason.last && reason.kind == Kind::Flip {
            Ending::Meets(reason.kind, reason.r)
        } else {
            Ending::At(reason.kind, reason.r)
        };
        let after = self.points.len();
        self.located.push(Located { after, ..reason });
        ending
    }

    /// The point to which the branch comes, unless it has just come from it.
    pub(super) fn crossing(&self) -> Option<CrossingOf<R>> {
        let Reading { reader, branch, .. } = &*self.followed;
        let found = reader.cross(branch, &self.points)?;
        let before = self.located.last();
        let new = before.is_none_or(|before| {
            let off = (before.r - found.located.r).abs();
            before.after + APART <= self.points.len() || off > SAME * before.point.r_size()
        });
        new.then_some(found)
    }

    /// The point to which the branch comes, if it is for that that there is no next one.
    pub(super) fn refused(&self, stop: &Stop<ErrorOf<R>>) -> Option<CrossingOf<R>> {
        let Reading { reader, branch, .. } = &*self.followed;
        match stop {
            Stop::Refused(why) => reader.refused(branch, &self.points, why),
            _ => None,
        }
    }

    /// What a step that went past such a point found on the way to it.
    pub(super) fn on_the_way(
        &self,
        findings: &Findings<R::Point>,
        corner: &Located<R::Point>,
    ) -> Vec<Located<R::Point>> {
        let Some(last) = self.points.last() else {
            return Vec::new();
        };
        let lost = findings.unexplained.first();
        let (from, to) = (last.r(), lost.map_or(corner.r, |lost| lost.between[0]));
        let off = |one: &Located<R::Point>| (one.r - corner.r).abs() > SAME * corner.point.r_size();
        let before = |one: &Located<R::Point>| (one.r - from) * (one.r - to) <= 0.0 && off(one);
        let kept = |one: &&Located<R::Point>| !one.last && one.left.is_nan() && before(one);
        findings.located.iter().take_while(kept).cloned().collect()
    }

    /// Whether that accounts for all that changes on the way to it.
    pub(super) fn accounts(&self, way: &[Located<R::Point>], corner: &Located<R::Point>) -> bool {
        let last = self.points.last();
        last.is_none_or(|last| explains(way, last, &corner.point))
    }

    /// Keeps what was found on the way to such a point.
    pub(super) fn keep(&mut self, way: Vec<Located<R::Point>>) {
        let (reader, problem) = (&self.followed.reader, &self.followed.branch.problem);
        for mut one in way {
            one.after = self.points.len();
            reader.refine(problem, &mut one);
            self.located.push(one);
        }
    }
}
