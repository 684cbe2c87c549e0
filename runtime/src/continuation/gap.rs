//! What lies between a point at which a branch is not smooth and the nearest orbits on both sides, as far away as those are.

use std::ops::ControlFlow;

use super::branch::Branch;
use super::ending::Ending;
use super::located::Located;
use super::path::Watched;
use super::range::Settings;
use super::reading::{CrossingOf, ErrorOf, Reader, Reading};
use super::walk::Walk;

/// Distance of the nearest point, relative to r, up to which nothing lies between.
const GAP: f64 = 1e-3;
/// Distance relative to r up to which it is gone towards the point, and points after which no further: towards where sliding
/// vanishes steps become ever shorter.
const NEAR: f64 = 1e-5;
const POINTS: usize = 200;
/// Share of the way by which the range begins behind the nearest point, which lies at its r but for rounding.
const BEHIND: f64 = 0.1;

impl<R: Reader> Walk<'_, R> {
    /// Comes to a point at which the branch is not smooth from as far away as its last one, and goes on beyond or ends there.
    pub(super) fn come_to(&mut self, crossing: CrossingOf<R>) -> Option<Ending<ErrorOf<R>>> {
        if !self.returns
            && let Some(way) = self.towards(&self.followed.branch, crossing.located.r)
        {
            let found = self.on_gap(way, &crossing.located);
            self.located.extend(found);
        }
        self.pass(crossing)
    }

    /// Looks for special points between this one and the first point of what continues it.
    pub(super) fn look_back(&mut self, branch: &Branch<R::Problem>, from: &Located<R::Point>) {
        if let Some(way) = self.towards(branch, from.r) {
            let found = self.on_gap(way, from).into_iter().rev();
            self.located.extend(found.map(Located::seen_from_behind));
        }
    }

    /// What lies on a way of this length to a point at which the branch is not smooth.
    fn on_gap(
        &mut self,
        (mut way, gap): (Reading<R>, f64),
        to: &Located<R::Point>,
    ) -> Vec<Located<R::Point>> {
        let begun = way.work();
        let mut walk = Walk::new(&mut way, true);
        let _: Ending<ErrorOf<R>> = walk.run(&mut |_| ControlFlow::Continue(()));
        let (mut found, searched) = (walk.located, walk.searched);
        self.searched += searched;
        self.searched += way.work().since(&begun);
        let least = NEAR * to.point.r_size() + to.error.max(0.0);
        found.retain(|one| {
            let apart = (one.r - to.r).abs();
            !one.last && apart > least && apart < gap
        });
        let after = self.points.len();
        found.iter_mut().for_each(|one| one.after = after);
        found
    }

    /// A branch from where this one is towards r, and how far away that is, if it is far.
    fn towards(&self, branch: &Branch<R::Problem>, r: f64) -> Option<(Reading<R>, f64)> {
        let base = branch.point.as_ref()?;
        let away = base.r - r;
        if away.abs() <= GAP * r.abs() {
            return None;
        }
        let settings = Settings {
            from: base.r + BEHIND * away,
            to: r + NEAR * r.abs().copysign(away),
            points: POINTS,
            ..branch.settings()
        };
        let slope = base.tangent[base.tangent.len() - 1];
        let direction = &base.tangent * -(slope * away).signum();
        let (problem, start) = (branch.problem.clone(), (base.z.clone(), base.r));
        let direction = (&direction, branch.r_scale());
        let started = Branch::set_out(problem, start, direction, settings).ok()?;
        let Reading {
            reader, accuracy, ..
        } = &*self.followed;
        Some((Reading::new(reader.clone(), started, *accuracy), away.abs()))
    }
}
