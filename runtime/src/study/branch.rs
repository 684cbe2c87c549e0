//! A branch of periodic orbits, and all that is reported of it.

use super::case::Along;
use super::orbit::{OrbitRecord, Sought};
use super::special::{Special, Specials};
use crate::bifurcation::{Findings, Kind, Located, Unexplained, detect, explain};
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
        let branch = OrbitBranch::start(self.family, &first, &self.search, settings)
            .map_err(OrbitError::Newton)?;
        let mut following = Following {
            sought: self,
            branch,
            orbits: Vec::new(),
            points: Vec::new(),
            specials: Specials::new(along),
        };
        let ended = following.run(&first, watch);
        let specials = following.specials;
        Ok(BranchRecord {
            along,
            points: following.points,
            ended: specials.unexplained().map_or(ended, Ended::unexplained),
            special: specials.finish(),
        })
    }
}

/// A branch being followed.
struct Following<'a, F: Family<N> + Clone, const N: usize> {
    sought: &'a Sought<'a, F, N>,
    branch: OrbitBranch<F, N>,
    orbits: Vec<Orbit<N, Mode<F, N>>>,
    points: Vec<OrbitRecord>,
    specials: Specials,
}

impl<F: Family<N> + Clone, const N: usize> Following<'_, F, N> {
    /// Goes on to the end; `first` is the orbit from which it starts.
    fn run(&mut self, first: &Orbit<N, Mode<F, N>>, watch: &mut dyn FnMut(&OrbitRecord)) -> Ended {
        while let Some(orbit) = self.branch.next() {
            let mut point = self.sought.record(&orbit);
            if self.points.is_empty() {
                point.work += first.work;
            }
            if let Some(end) = self.examine(&orbit, &mut point) {
                return self.end(end);
            }
            watch(&point);
            let endless = point.period > ENDLESS * first.period;
            self.points.push(point);
            self.orbits.push(orbit);
            if endless {
                return Ended::endless();
            }
        }
        let reason = match self.branch.ending() {
            Some(Ending::StepTooSmall(_)) => explain(&self.orbits, self.sought.search.accuracy),
            _ => None,
        };
        match reason {
            Some(reason) => self.end(reason),
            None => self
                .branch
                .ending()
                .map_or_else(Ended::endless, Ended::from),
        }
    }

    /// Looks for bifurcations on the way to `orbit`; gives the one that ends the branch before it.
    fn examine(
        &mut self,
        orbit: &Orbit<N, Mode<F, N>>,
        point: &mut OrbitRecord,
    ) -> Option<Located<Orbit<N, Mode<F, N>>>> {
        let (mut path, before) = (self.branch.path()?, self.orbits.last()?);
        let accuracy = self.sought.search.accuracy;
        let findings = detect(&mut path, before, orbit, accuracy);
        point.work += path.work();
        if !findings.unexplained.is_empty() {
            // Beyond a graze, what was found is not the same motion any more.
            let end = explain(&self.orbits, accuracy);
            if end.is_some() {
                return end;
            }
        }
        self.specials.take(findings);
        None
    }

    fn end(&mut self, reason: Located<Orbit<N, Mode<F, N>>>) -> Ended {
        let ended = Ended::at(reason.kind, self.specials.along.value(reason.r));
        self.specials.take(Findings::of(reason));
        ended
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
