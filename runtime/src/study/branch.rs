//! A branch of periodic orbits, and all that is reported of it.

use super::case::Along;
use super::orbit::{OrbitRecord, Sought};
use super::special::{Special, Specials};
use crate::bifurcation::{Findings, Kind, Unexplained, detect, explain};
use crate::continuation::{Ending, Settings};
use crate::flow::{Family, Flow, FlowError};
use crate::shooting::{Orbit, OrbitBranch, OrbitError};

type Mode<F, const N: usize> = <<F as Family<N>>::Flow as Flow<N>>::Mode;

/// A branch whose period has grown this many times has none in the end.
const ENDLESS: f64 = 1e6;

/// A branch as it is reported, whatever model it belongs to.
#[derive(Debug, Clone, PartialEq)]
pub struct BranchRecord {
    /// What was followed.
    pub along: Along,
    /// Its orbits in the order in which they were found.
    pub points: Vec<OrbitRecord>,
    /// Where its stability or its make-up changes.
    pub special: Vec<Special>,
    /// Why it ended.
    pub ended: Ended,
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

impl<F: Family<N> + Clone, const N: usize> Sought<'_, F, N> {
    /// Follows the orbit at the beginning of `along`; `watch` sees each point as it is found.
    pub(super) fn branch(
        &self,
        along: Along,
        watch: &mut dyn FnMut(&OrbitRecord),
    ) -> Result<BranchRecord, OrbitError> {
        let (from, to) = along.span();
        let first = self.orbit(from)?;
        let settings = Settings::new(from, to, self.search.accuracy);
        let mut branch = OrbitBranch::start(self.family, &first, &self.search, settings)
            .map_err(OrbitError::Newton)?;
        let mut points: Vec<OrbitRecord> = Vec::new();
        let mut orbits: Vec<Orbit<N, Mode<F, N>>> = Vec::new();
        let mut specials = Specials::new(along);
        while let Some(orbit) = branch.next() {
            let mut point = self.record(&orbit);
            if points.is_empty() {
                point.work += first.work;
            }
            if let (Some(mut path), Some(before)) = (branch.path(), orbits.last()) {
                specials.take(detect(&mut path, before, &orbit, self.search.accuracy));
                point.work += path.work();
            }
            watch(&point);
            let endless = point.period > ENDLESS * first.period;
            points.push(point);
            orbits.push(orbit);
            if endless {
                break;
            }
        }
        let mut ended = branch.ending().map_or_else(Ended::endless, Ended::from);
        if let Some(Ending::StepTooSmall(_)) = branch.ending()
            && let Some(reason) = explain(&orbits, self.search.accuracy)
        {
            ended = Ended::at(reason.kind, along.value(reason.r));
            specials.take(Findings::of(reason));
        }
        Ok(BranchRecord {
            along,
            points,
            ended: specials.unexplained().map_or(ended, Ended::unexplained),
            special: specials.finish(),
        })
    }
}

impl Ended {
    /// A bifurcation beyond which no orbit continues the branch, or none that can be reached.
    fn at(kind: Kind, r: f64) -> Self {
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

    /// A change that no bifurcation accounts for.
    fn unexplained(change: &Unexplained) -> Self {
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

    /// The period grows without bound, as it does towards rest.
    fn endless() -> Self {
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
