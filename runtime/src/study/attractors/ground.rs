//! A system at one value of its parameters, with all that its motions are followed with.

use super::record::Attractor;
use super::setting::Region;
use crate::flow::FlowError;
use crate::integrate::Tolerance;
use crate::motion::{Family, Flow, Segment, word};
use crate::shooting::Search;
use crate::study::question::Case;
use crate::study::system::System;

/// Relative accuracy with which motions are followed until they are recognised.
pub(super) const ROUGH: f64 = 1e-7;

/// What the start of a case, in which nothing is followed, settles on.
pub(in crate::study) fn closely(system: &System, case: &Case) -> Result<Attractor, FlowError> {
    let nowhere = Region { sides: Vec::new() };
    let ground = Ground::new(system, case.clone(), &nowhere)?;
    Ok(ground.closely(&ground.start(0)))
}

pub(super) struct Ground<'a> {
    pub(super) system: &'a System,
    pub(super) case: Case,
    pub(super) family: Family,
    /// The rough one.
    pub(super) flow: Box<dyn Flow>,
    /// How large states are where starts lie.
    pub(super) usual: Vec<f64>,
    region: &'a Region,
    others: Vec<f64>,
}

impl<'a> Ground<'a> {
    /// The system of a case in which nothing is followed.
    pub(super) fn new(
        system: &'a System,
        case: Case,
        region: &'a Region,
    ) -> Result<Self, FlowError> {
        let (family, others) = (system.family(&case), system.start(&case));
        let usual = region.magnitude(&others);
        let rough = family.with_tolerance(Tolerance::for_accuracy(ROUGH));
        let flow = rough.with_magnitude(&usual).at(0.0)?;
        Ok(Self {
            system,
            case,
            family,
            flow,
            usual,
            region,
            others,
        })
    }

    /// The start at these shares of the sides of the region.
    pub(super) fn at(&self, shares: &[f64]) -> Vec<f64> {
        self.region.at(shares.iter().copied(), &self.others)
    }

    /// Whether contacts act as declared.
    pub(super) fn touches(&self) -> bool {
        self.system.touches(&self.case)
    }

    /// The modes that a motion runs through, of contacts that act as declared.
    pub(super) fn word(&self, segments: &[Segment]) -> Option<String> {
        self.touches().then(|| word(self.system.info(), segments))
    }

    /// How the orbit is looked for on which the motion from a start settles, or of this period.
    pub(super) fn search(&self, start: Vec<f64>, period: Option<f64>) -> Search {
        Search {
            start,
            modes: Vec::new(),
            period,
            accuracy: self.case.accuracy,
            segments: 1,
        }
    }

    pub(super) fn start(&self, k: usize) -> Vec<f64> {
        self.region.start(k, &self.others)
    }
}
