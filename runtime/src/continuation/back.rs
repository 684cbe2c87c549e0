//! What lies between a point at which a branch is not smooth and the first beyond it, as far away as that was found.

use std::ops::ControlFlow;

use super::branch::{Branch, Started};
use super::ending::Ending;
use super::located::Located;
use super::range::Settings;
use super::reading::{ErrorOf, Reader, Reading};
use super::walk::Walk;

/// Distance of the first point beyond, relative to r, up to which nothing lies before it.
const GAP: f64 = 1e-3;
/// Distance, relative to r, up to which a special point is the one from which the branch goes on.
const SAME: f64 = 1e-7;
/// Points after which it is gone back no further: towards where sliding vanishes steps become ever shorter.
const POINTS: usize = 50;

impl<R: Reader> Walk<'_, R> {
    /// Looks for special points between this one and the first point of what continues it, by going back from there.
    pub(super) fn look_back(&mut self, from: &Located<R::Point>, started: &Started<R::Problem>) {
        let away = (started.1.r - from.r).abs();
        if away <= GAP * from.r.abs() {
            return;
        }
        let Some(mut back) = self.turned_back(from.r, started) else {
            return;
        };
        let begun = back.work();
        let mut walk = Walk::new(&mut back, true);
        let _: Ending<ErrorOf<R>> = walk.run(&mut |_| ControlFlow::Continue(()));
        let (found, searched) = (walk.located, walk.searched);
        self.searched += searched;
        self.searched += back.work().since(&begun);
        let after = self.points.len();
        let between = |one: &Located<R::Point>| {
            let apart = (one.r - from.r).abs();
            !one.last && apart > SAME * from.r.abs() + from.error.max(0.0) && apart < away
        };
        let found = found.into_iter().rev().filter(between);
        let found = found.map(|one| one.seen_from_behind(after));
        self.located.extend(found);
    }

    /// A branch from the first point of another back to r.
    fn turned_back(&self, r: f64, (branch, first): &Started<R::Problem>) -> Option<Reading<R>> {
        let settings = Settings {
            from: first.r,
            to: r,
            points: POINTS,
            ..branch.settings()
        };
        let (problem, start) = (branch.problem.clone(), (first.z.clone(), first.r));
        let direction = (&-&first.tangent, first.r_scale);
        let back = Branch::set_out(problem, start, direction, settings).ok()?;
        let Reading {
            reader, accuracy, ..
        } = &*self.followed;
        Some(Reading::new(reader.clone(), back, *accuracy))
    }
}
