//! A branch of periodic orbits as it is reported, with those that leave it.

use std::ops::ControlFlow;

use super::special::Special;
use crate::study::ended::Ended;
use crate::study::orbit::OrbitRecord;
use crate::study::question::Along;

/// Told of each orbit as it is found; a break ends the branch there.
pub(super) type Watch<'a> = &'a mut dyn FnMut(&OrbitRecord) -> ControlFlow<()>;

/// A branch as it is reported, whatever model it belongs to.
#[derive(Debug, Clone, PartialEq)]
pub struct BranchRecord {
    /// What was followed.
    pub along: Along,
    /// The label of the special point of the branch above from which it leaves; `None` for the first.
    pub from: Option<String>,
    /// That point as one of this branch, which begins there, or passes it after so many of its points.
    pub root: Option<Special>,
    /// Its orbits in their order along it.
    pub points: Vec<OrbitRecord>,
    /// Where its stability or its make-up changes, in the same order.
    pub special: Vec<Special>,
    /// Why it ended.
    pub ended: Ended,
    /// Why it ended at its other side, if it was followed both ways.
    pub began: Option<Ended>,
    /// The branches that leave it.
    pub branches: Vec<BranchRecord>,
}

impl BranchRecord {
    /// The first end, of this branch or of those that leave it, that does not lie in the branch itself.
    #[must_use]
    pub fn unlocated(&self) -> Option<&Ended> {
        let own = self.began.iter().chain([&self.ended]);
        let below = self.branches.iter().filter_map(Self::unlocated);
        own.filter(|ended| !ended.is_located()).chain(below).next()
    }

    /// Whether it, or a branch that leaves it, would have gone on if it had not been interrupted.
    #[must_use]
    pub fn is_interrupted(&self) -> bool {
        let mut ends = self.began.iter().chain([&self.ended]);
        ends.any(Ended::is_interrupted) || self.branches.iter().any(Self::is_interrupted)
    }

    /// This branch and all that leave it, each before those that leave it in turn.
    #[must_use]
    pub fn all(&self) -> Vec<&Self> {
        let below = self.branches.iter().flat_map(Self::all);
        std::iter::once(self).chain(below).collect()
    }
}
