//! The branches on which the motions lie that starts have found.

use crate::continuation::Kind;
use crate::study::branch::BranchRecord;

/// A motion among those that starts have found.
#[derive(Debug, Clone, PartialEq)]
pub struct Spot {
    /// The design variable there.
    pub r: f64,
    /// Its place among the motions found there, or, of a saddle, among the saddles.
    pub place: usize,
    /// Whether it is one of the saddles.
    pub saddle: bool,
}

/// A branch on which motions lie that starts have found, followed both ways over the range of the design variable.
#[derive(Debug, Clone, PartialEq)]
pub struct Followed {
    /// The branch; it begins at one of the motions.
    pub branch: BranchRecord,
    /// The motions.
    pub motions: Vec<Spot>,
}

/// All branches on which periodic motions lie that starts have found.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FollowedRecord {
    /// Each of them once.
    pub branches: Vec<Followed>,
    /// Motions that could not be followed, with the reason.
    pub failed: Vec<(Spot, String)>,
}

impl Followed {
    /// Whether it is an isola: it comes back to its beginning, and no branch crosses it.
    #[must_use]
    pub fn is_isola(&self) -> bool {
        let crossed = |kind| matches!(kind, Kind::BranchPoint | Kind::SymmetryBreaking);
        self.branch.ended.is_closed() && !self.branch.special.iter().any(|one| crossed(one.kind))
    }

    /// The least and the largest value of the design variable on it.
    #[must_use]
    pub fn span(&self) -> [f64; 2] {
        let points = self.branch.points.iter().filter_map(|point| point.r);
        let all = points.chain(self.branch.special.iter().map(|one| one.r));
        all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], r| {
            [low.min(r), high.max(r)]
        })
    }
}

impl FollowedRecord {
    /// Whether it would have gone on if it had not been interrupted.
    #[must_use]
    pub fn is_interrupted(&self) -> bool {
        self.branches.iter().any(|one| one.branch.is_interrupted())
    }

    /// Branches and motions in the order in which the motions were found.
    pub(super) fn sort(&mut self) {
        let key = |spot: &Spot| (spot.saddle, spot.place);
        let order = |a: &Spot, b: &Spot| a.r.total_cmp(&b.r).then(key(a).cmp(&key(b)));
        for one in &mut self.branches {
            one.motions.sort_by(order);
        }
        self.branches
            .sort_by(|a, b| match (a.motions.first(), b.motions.first()) {
                (Some(a), Some(b)) => order(a, b),
                (a, b) => a.is_some().cmp(&b.is_some()),
            });
        self.failed.sort_by(|a, b| order(&a.0, &b.0));
    }
}
