//! Where a branch turns and no multiplier says so: its design variable stands still, as far as errors tell, or a multiplier comes
//! to 1 and goes back, as where orbits become the images of themselves.

use std::ops::Range;

use super::kind::Kind;
use super::located::Located;
use super::path::Watched;
use super::reading::Reader;
use super::walk::Walk;

/// Error of r where it turns on a plateau, over the accuracy: that of either end.
const DOUBT: f64 = 2.0;

impl<R: Reader> Walk<'_, R> {
    /// Keeps the fold of a plateau that the branch has left the way it came, if nothing there is known to turn it.
    pub(super) fn note_plateau(&mut self) {
        let accuracy = self.followed.accuracy;
        let plateau = turned(&self.points, accuracy).filter(|_| R::TURNS_AT_FOLDS);
        let Some(plateau) = plateau else { return };
        // Along a canard r stands still as well, and comes and goes by the errors of points, but no multiplier is 1.
        let marginal = |point: &R::Point| point.marginal().is_some_and(|count| count > 0);
        if !self.points[plateau.clone()].iter().any(marginal) {
            return;
        }
        let there = |one: &Located<R::Point>| (plateau.start..=plateau.end).contains(&one.after);
        let turns = |one: &Located<R::Point>| one.kind == Kind::Fold || one.abrupt;
        if self.located.iter().any(|one| there(one) && turns(one)) {
            return;
        }
        let way = (self.points[plateau.start].r() - self.points[plateau.start - 1].r()).signum();
        let far = |i: &usize| way * self.points[*i].r();
        let Some(at) = plateau.max_by(|i, j| far(i).total_cmp(&far(j))) else {
            return;
        };
        let r = self.points[at].r();
        let error = DOUBT * accuracy * self.points[at].r_scale();
        let mut fold = Located::at(Kind::Fold, r, self.points[at].clone());
        (fold.error, fold.after) = (error, at);
        let reading = &*self.followed;
        reading.reader.refine(&reading.branch.problem, &mut fold);
        let before = self.located.partition_point(|one| one.after <= at);
        self.located.insert(before, fold);
    }

    /// Forgets what seemed to be folds at this r, which the branch comes ever nearer to without an end: errors turn r there.
    pub(super) fn forget_turns_at(&mut self, r: f64) {
        let scale = self.points.last().map_or(r.abs(), Watched::r_scale);
        let near = DOUBT * self.followed.accuracy * scale;
        self.located.retain(|one| {
            one.kind != Kind::Fold || one.abrupt || (one.r - r).abs() > near.max(one.error)
        });
    }
}

/// The points among which r stands still, at least one, if with the last one a branch leaves them the way it came: of two that are
/// so near to each other neither the sign of their step nor a multiplier tells that r turns, but those before and behind do.
fn turned<P: Watched>(points: &[P], accuracy: f64) -> Option<Range<usize>> {
    let step = |i: usize| points[i].r() - points[i - 1].r();
    let certain = |i: &usize| step(*i).abs() > accuracy * points[*i].r_scale();
    let left = points
        .len()
        .checked_sub(1)
        .filter(|i| *i > 0 && certain(i))?;
    let came = (1..left).rev().find(certain)?;
    (step(came) * step(left) < 0.0).then_some(came..left)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Clone)]
    struct At(f64);

    impl Watched for At {
        fn r(&self) -> f64 {
            self.0
        }

        fn r_scale(&self) -> f64 {
            self.0.abs()
        }

        fn slope(&self) -> f64 {
            1.0
        }
    }

    #[test]
    fn a_plateau_is_left_the_way_it_was_come_by() {
        let plateau = |all: &[f64]| {
            let points: Vec<At> = all.iter().copied().map(At).collect();
            turned(&points, 1e-6)
        };
        let flat = 1.0 + 1e-7;
        assert_eq!(plateau(&[0.8, 0.9, 1.0, flat, 1.0, 0.9]), Some(2..5));
        assert_eq!(plateau(&[0.8, 0.9, 1.0, 0.9]), Some(2..3));
        // It goes on as it came, or has not been left yet.
        assert_eq!(plateau(&[0.8, 0.9, 1.0, flat, 1.0, 1.1]), None);
        assert_eq!(plateau(&[0.8, 0.9, 1.0, flat, 1.0]), None);
    }
}
