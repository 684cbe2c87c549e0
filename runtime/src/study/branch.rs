//! A branch of periodic orbits, and all that is reported of it.

use nalgebra::Complex;

use super::case::Along;
use super::orbit::{OrbitRecord, Sought};
use crate::continuation::{Ending, Settings};
use crate::flow::{Family, FlowError};
use crate::shooting::{OrbitBranch, OrbitError};

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

/// A point of a branch where something changes.
#[derive(Debug, Clone, PartialEq)]
pub struct Special {
    /// What changes: `fold`, `flip`, `torus`, `grazing-sliding`, ...
    pub kind: &'static str,
    /// Kind and number, for instance `PD1`.
    pub label: String,
    /// The design variable, in the user's own values.
    pub r: f64,
    /// The period there.
    pub period: f64,
    /// The multipliers there.
    pub multipliers: Vec<Complex<f64>>,
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
        for orbit in branch.by_ref() {
            let mut point = self.record(&orbit);
            if points.is_empty() {
                point.work += first.work;
            }
            watch(&point);
            let endless = point.period > ENDLESS * first.period;
            points.push(point);
            if endless {
                break;
            }
        }
        let ended = branch.ending();
        let special = Vec::new();
        Ok(BranchRecord {
            along,
            ended: ended.map_or_else(Ended::endless, Ended::from),
            points,
            special,
        })
    }
}

impl Ended {
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
