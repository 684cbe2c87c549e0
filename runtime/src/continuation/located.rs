//! Special points of a branch, and changes that none of them explains.

use super::kind::Kind;
use super::path::{Spot, Watched};

/// A special point that was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Located<P> {
    /// Which.
    pub kind: Kind,
    /// The design variable there.
    pub r: f64,
    /// The point of the branch there, or the nearest on the side from which the branch came.
    pub point: P,
    /// Whether the branch is none any more beyond, or only runs back.
    pub last: bool,
    /// How often the point is gone around while one of the branch beside it is: 2 where a doubled one ends.
    pub turns: usize,
    /// r and number of unstable directions at the points between which it was found.
    pub sides: [(f64, usize); 2],
    /// How many points of the branch precede it.
    pub after: usize,
    /// Estimated error of r.
    pub error: f64,
    /// The same of how long what is followed takes there, which at a fold changes where r does not; NaN where that is not
    /// measured.
    pub lasting: f64,
    /// r-component of the unit tangent with which the branch leaves it, where it is not smooth.
    pub(super) left: f64,
    pub(super) share: f64,
    /// Whether it was found between two regimes.
    pub(super) abrupt: bool,
}

impl<P> Located<P> {
    /// A special point found by other means than a path.
    #[must_use]
    pub fn at(kind: Kind, r: f64, point: P) -> Self {
        Self {
            kind,
            r,
            point,
            last: false,
            turns: 1,
            sides: [(r, 0); 2],
            after: 0,
            error: f64::NAN,
            lasting: f64::NAN,
            left: f64::NAN,
            share: 1.0,
            abrupt: false,
        }
    }

    /// The same on a branch that goes the other way.
    pub(super) fn seen_from_behind(self) -> Self {
        let [from, to] = self.sides;
        Self {
            sides: [to, from],
            left: f64::NAN,
            ..self
        }
    }

    pub(super) fn between(kind: Kind, ends: [&Spot<P>; 2], at: Spot<P>) -> Self
    where
        P: Watched,
    {
        Self {
            r: at.point.r(),
            sides: ends.map(|spot| (spot.point.r(), spot.point.unstable())),
            share: at.share,
            ..Self::at(kind, f64::NAN, at.point)
        }
    }

    /// Which side of it a branch at `r` lies on: by how many directions the branch on which it was found
    /// is more unstable there than on the other side. `None` where that cannot be told.
    #[must_use]
    pub fn more_unstable_towards(&self, r: f64) -> Option<i64> {
        let [here, there] = self.unstable_from(r)?;
        let change = here as i64 - there as i64;
        (change != 0).then_some(change)
    }

    /// How many unstable directions a branch that leaves here has at `r`, as long as nothing else happens on it: the two
    /// branches exchange their stability, so that it has as many as the other one has across the crossing.
    /// `None` where that cannot be told.
    #[must_use]
    pub fn unstable_beside(&self, r: f64) -> Option<usize> {
        let [here, across] = self.unstable_from(r)?;
        (here.abs_diff(across) == 1).then_some(across)
    }

    /// The numbers of unstable directions on the side of `r` and on the other.
    fn unstable_from(&self, r: f64) -> Option<[usize; 2]> {
        let [from, to] = self.sides;
        let between = (from.0 - self.r) * (to.0 - self.r) < 0.0;
        let (here, there) = if (from.0 - self.r) * (r - self.r) > 0.0 {
            (from, to)
        } else {
            (to, from)
        };
        (between && r != self.r).then_some([here.1, there.1])
    }
}

/// Drops what was found within two steps and is nearer to each other than its errors: of two folds both, as rounding turns r
/// there, and turns it back; beside one, a branch point, as it is one multiplier that passes 1 at both; and what else passes or
/// turns where a symmetry is lost, or that once more.
pub(super) fn drop_pairs<P>(located: &mut Vec<Located<P>>) {
    let near = |two: &[Located<P>]| {
        let near = (two[1].r - two[0].r).abs() <= two[0].error.max(two[1].error);
        near && two[1].after - two[0].after <= 1
    };
    let folds = |two: &[Located<P>]| two.iter().all(|found| found.kind == Kind::Fold);
    while let Some(first) = located.windows(2).position(|two| near(two) && folds(two)) {
        located.drain(first..first + 2);
    }
    let kinds = |two: &[Located<P>]| match [two[0].kind, two[1].kind] {
        [Kind::SymmetryBreaking, Kind::SymmetryBreaking] => {
            Some(usize::from(two[1].error >= two[0].error))
        }
        [
            Kind::Fold | Kind::SymmetryBreaking,
            Kind::BranchPoint | Kind::Fold,
        ] => Some(1),
        [
            Kind::BranchPoint | Kind::Fold,
            Kind::Fold | Kind::SymmetryBreaking,
        ] => Some(0),
        _ => None,
    };
    let beside = |two: &[Located<P>]| kinds(two).filter(|_| near(two));
    let point = |(first, two): (usize, &[Located<P>])| Some(first + beside(two)?);
    while let Some(point) = located.windows(2).enumerate().find_map(point) {
        located.remove(point);
    }
}

/// A change in the number of unstable directions, or of the regime, with no special point to explain it.
#[derive(Debug, Clone, PartialEq)]
pub struct Unexplained {
    /// The design variable before and after.
    pub between: [f64; 2],
    /// Number of unstable directions before and after.
    pub unstable: [usize; 2],
    /// Why it was not looked at more closely.
    pub reason: String,
}

impl Unexplained {
    /// What happens between two points, and why it was not looked at more closely.
    pub(super) fn between<P: Watched>(ends: [&P; 2], reason: &str) -> Self {
        Self {
            between: ends.map(Watched::r),
            unstable: ends.map(Watched::unstable),
            reason: reason.to_owned(),
        }
    }
}

/// The share of a step that goes along the design variable below which it has no sign.
const SLOPE: f64 = 1e-3;
/// Angle by which a branch may turn beyond a point at which it is not smooth, rad: as much as on any step.
const BEND: f64 = 0.35;

impl<P: Watched> Findings<P> {
    /// Whether the branch, beyond a point at which it is not smooth, has been taken up the wrong way round.
    pub(super) fn runs_back(&self, to: &P) -> bool {
        let corner = self.located.iter().rposition(|found| !found.left.is_nan());
        corner.is_some_and(|corner| {
            let turns = self.located[corner..].iter();
            let turns = turns.filter(|found| found.kind == Kind::Fold).count();
            let way = if turns % 2 == 0 { 1.0 } else { -1.0 };
            way * self.located[corner].left * to.slope() < 0.0
        })
    }

    /// Whether the branch turns so much between the last point at which it is not smooth and this one that what lies between
    /// them may be another part of it, as far as its slopes tell.
    pub(super) fn bends(&self, to: &P) -> bool {
        let corner = self.located.iter().rfind(|found| !found.left.is_nan());
        corner.is_some_and(|corner| {
            let [left, arrives] =
                [corner.left, to.slope()].map(|slope| slope.clamp(-1.0, 1.0).acos());
            (left - arrives).abs() > BEND
        })
    }

    /// Whether the design variable turns though nothing was found at which it does: the step went past what its unknowns
    /// can tell, and they come round to the solutions before it.
    pub(super) fn turns_unseen(&self, ends: [&P; 2]) -> bool {
        let [from, to] = ends.map(Watched::slope);
        let turns = from * to < 0.0 && from.abs().max(to.abs()) > SLOPE;
        // Where events change and nothing says how r leaves that, it goes on as before.
        let goes_on = |one: &Located<P>| one.abrupt && one.left.is_nan();
        turns && self.located.iter().all(goes_on) && ends[0].same_regime(ends[1])
    }
}

/// All that was found on one step of a branch.
#[derive(Debug, Clone, PartialEq)]
pub struct Findings<P> {
    /// Special points, in their order along the branch.
    pub located: Vec<Located<P>>,
    /// What they do not explain.
    pub unexplained: Vec<Unexplained>,
    /// Where the branch leaves what was asked for.
    pub bound: Option<P>,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(kind: Kind, r: f64, after: usize) -> Located<()> {
        Located {
            error: 1e-9,
            after,
            ..Located::at(kind, r, ())
        }
    }

    fn left(mut located: Vec<Located<()>>) -> Vec<Kind> {
        drop_pairs(&mut located);
        located.iter().map(|one| one.kind).collect()
    }

    #[test]
    fn what_no_error_parts_is_one_fold_or_none() {
        use Kind::{BranchPoint, Flip, Fold, SymmetryBreaking};
        let near = |kinds: [Kind; 2]| kinds.map(|kind| found(kind, 1.0, 3)).to_vec();
        assert_eq!(left(near([Fold, Fold])), []);
        assert_eq!(left(near([Fold, BranchPoint])), [Fold]);
        assert_eq!(left(near([BranchPoint, Fold])), [Fold]);
        assert_eq!(left(near([Flip, Fold])), [Flip, Fold]);
        for other in [SymmetryBreaking, Fold, BranchPoint] {
            let each = [[SymmetryBreaking, other], [other, SymmetryBreaking]];
            assert!(
                each.into_iter()
                    .all(|two| left(near(two)) == [SymmetryBreaking])
            );
        }
        for (r, after) in [(1.0 + 1e-8, 3), (1.0, 5)] {
            let two = vec![found(Fold, 1.0, 3), found(BranchPoint, r, after)];
            assert_eq!(left(two), [Fold, BranchPoint]);
        }
    }
}
