//! A branch of periodic orbits as it is reported, with those that leave it.

use std::ops::ControlFlow;

use super::case::Along;
use super::orbit::OrbitRecord;
use super::special::Special;
use crate::bifurcation::{Kind, Unexplained};
use crate::continuation::Ending;
use crate::flow::FlowError;

/// A branch whose period has grown this many times has none in the end.
pub(super) const ENDLESS: f64 = 1e6;

/// Told of each orbit as it is found; a break ends the branch there.
pub(super) type Watch<'a> = &'a mut dyn FnMut(&OrbitRecord) -> ControlFlow<()>;

/// How an interrupted branch ended.
const INTERRUPTED: &str = "interrupted";

/// A branch as it is reported, whatever model it belongs to.
#[derive(Debug, Clone, PartialEq)]
pub struct BranchRecord {
    /// What was followed.
    pub along: Along,
    /// The label of the special point of the branch above from which it leaves; `None` for the first.
    pub from: Option<String>,
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
        own.filter(|ended| !ended.located).chain(below).next()
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

/// Why a branch ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Ended {
    /// In one word, for instance `reached-end`.
    pub word: &'static str,
    /// Whether this is a reason that lies in the branch and not in the computation.
    pub located: bool,
    /// In a sentence.
    pub reason: String,
}

impl Ended {
    /// A bifurcation beyond which no orbit continues the branch, or none that can be reached.
    pub(super) fn at(kind: Kind, r: f64) -> Self {
        let reason = match kind {
            Kind::Fold => format!("it turns at {r}, too sharply to be followed round"),
            _ => format!(
                "it meets a {} point at {r}: no orbit continues it",
                kind.name()
            ),
        };
        Self {
            word: kind.name(),
            located: true,
            reason,
        }
    }

    /// A doubled orbit that has become the one from which it branches.
    pub(super) fn meets(r: f64) -> Self {
        Self {
            word: Kind::Flip.name(),
            located: true,
            reason: format!(
                "at {r} both halves of the orbit become one: it meets the branch from which it doubles"
            ),
        }
    }

    /// A doubled orbit that cannot be told any more from the one from which it branches.
    pub(super) fn falls_back(r: f64) -> Self {
        Self {
            word: "step-too-small",
            located: false,
            reason: format!(
                "at {r} it falls back on the branch from which it doubles, however short the step"
            ),
        }
    }

    /// A branch that has come round to where it began.
    pub(super) fn closed(r: f64) -> Self {
        Self {
            word: "closed",
            located: true,
            reason: format!("it is closed: it came back to the orbit at {r} with which it began"),
        }
    }

    /// A change that no bifurcation accounts for.
    pub(super) fn unexplained(change: &Unexplained) -> Self {
        let ([from, to], [before, after]) = (change.between, change.unstable);
        let reason = &change.reason;
        Self {
            word: "unexplained-change",
            located: false,
            reason: format!(
                "between {from} and {to} its {before} unstable multipliers become {after}, or its events change, and no \
                 bifurcation was located there: {reason}"
            ),
        }
    }

    /// A branch that nobody wanted to be followed any further.
    pub(super) fn interrupted() -> Self {
        Self {
            word: INTERRUPTED,
            located: false,
            reason: "it was interrupted".to_owned(),
        }
    }

    /// Whether it ended because whoever watched it wanted no more.
    #[must_use]
    pub fn is_interrupted(&self) -> bool {
        self.word == INTERRUPTED
    }

    /// The period grows without bound, as it does towards rest.
    pub(super) fn endless() -> Self {
        Self {
            word: "infinite-period",
            located: true,
            reason: format!("its period has grown more than {ENDLESS:e} times"),
        }
    }
}

impl From<&Ending<FlowError>> for Ended {
    fn from(ending: &Ending<FlowError>) -> Self {
        let (word, located, reason) = match ending {
            Ending::ReachedEnd => ("reached-end", true, "its end is reached".to_owned()),
            Ending::ReachedStart => (
                "reached-start",
                true,
                "it turned and came back to where it began".to_owned(),
            ),
            Ending::StepTooSmall(failure) => (
                "step-too-small",
                false,
                format!("no step is small enough: {failure}"),
            ),
            Ending::Creeping(length) => (
                "step-too-small",
                false,
                format!("no step was longer than {length:e} of its extent for too long"),
            ),
            Ending::TooManyPoints => (
                "too-many-points",
                false,
                "it has more points than are allowed".to_owned(),
            ),
            Ending::Refused(error @ FlowError::Vanished { .. }) => {
                ("equilibrium", true, error.to_string())
            }
            Ending::Refused(error) => ("refused", false, error.to_string()),
        };
        Self {
            word,
            located,
            reason,
        }
    }
}
