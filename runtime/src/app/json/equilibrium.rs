//! Equilibria as JSON.

use nalgebra::Complex;

use super::certificate::EquilibriumCertificate;
use super::work::Counts;
use super::{Named, Range, parameters, states, units};
use crate::equilibrium::{Proof, Unproven};
use crate::model::ModelInfo;
use crate::study::{Case, EquilibriaRecord, EquilibriumRecord, Extent, SpecialEquilibrium};

/// All equilibria at one value of every parameter.
#[derive(serde::Serialize)]
pub(in crate::app) struct Equilibria<'a> {
    model: &'a str,
    dynamics: String,
    parameters: Named<'a, f64>,
    equilibria: Vec<Equilibrium<'a>>,
    units: Named<'a, &'static str>,
}

/// A branch of equilibria.
#[derive(serde::Serialize)]
pub(in crate::app) struct EquilibriumBranch<'a> {
    model: &'a str,
    dynamics: String,
    parameters: Named<'a, f64>,
    along: Range<'a>,
    points: Vec<Equilibrium<'a>>,
    special: Vec<Special<'a>>,
    ended: &'static str,
    reason: &'a str,
    units: Named<'a, &'static str>,
    work: Counts,
}

/// An equilibrium, or a set of sticking ones.
#[derive(serde::Serialize)]
struct Equilibrium<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    r: Option<f64>,
    parameters: Named<'a, f64>,
    state: Named<'a, f64>,
    eigenvalues: Vec<[f64; 2]>,
    stability: &'static str,
    mode: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    set: Option<Set<'a>>,
    artefact: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    certificate: Option<EquilibriumCertificate<'a>>,
}

/// How far a set reaches.
#[derive(serde::Serialize)]
struct Set<'a> {
    dimension: usize,
    min: Named<'a, f64>,
    max: Named<'a, f64>,
}

/// A special point.
#[derive(serde::Serialize)]
struct Special<'a> {
    kind: &'static str,
    label: &'a str,
    r: f64,
    state: Named<'a, f64>,
    eigenvalues: Vec<[f64; 2]>,
    period: Option<f64>,
    artefact: bool,
}

fn pairs(values: &[Complex<f64>]) -> Vec<[f64; 2]> {
    values.iter().map(|value| [value.re, value.im]).collect()
}

impl<'a> Equilibria<'a> {
    pub(in crate::app) fn new(
        info: &'a ModelInfo,
        case: &Case,
        found: &'a [EquilibriumRecord],
    ) -> Self {
        Self {
            model: info.command,
            dynamics: case.dynamics.to_string(),
            parameters: parameters(info, &case.parameters),
            equilibria: found
                .iter()
                .map(|one| Equilibrium::new(info, one))
                .collect(),
            units: units(info),
        }
    }
}

impl<'a> Equilibria<'a> {
    /// The same with a proof for each, or why there is none, if proofs were asked for.
    pub(in crate::app) fn with_proofs(
        mut self,
        info: &'a ModelInfo,
        proofs: Option<&'a [Result<Proof, Unproven>]>,
    ) -> Self {
        let proofs = proofs.unwrap_or_default();
        for (one, proof) in self.equilibria.iter_mut().zip(proofs) {
            one.certificate = Some(EquilibriumCertificate::new(info, proof));
        }
        self
    }
}

impl<'a> EquilibriumBranch<'a> {
    pub(in crate::app) fn new(
        info: &'a ModelInfo,
        case: &Case,
        branch: &'a EquilibriaRecord,
    ) -> Self {
        let points = branch.points.iter();
        let special = branch.special.iter();
        Self {
            model: info.command,
            dynamics: case.dynamics.to_string(),
            parameters: parameters(info, &case.parameters),
            along: Range::new(info, &branch.along),
            points: points.map(|one| Equilibrium::new(info, one)).collect(),
            special: special.map(|point| Special::new(info, point)).collect(),
            ended: branch.ended.word(),
            reason: &branch.ended.reason,
            units: units(info),
            work: Counts::from(&branch.work),
        }
    }
}

impl<'a> Equilibrium<'a> {
    fn new(info: &'a ModelInfo, one: &'a EquilibriumRecord) -> Self {
        let set = |set: &'a Extent| Set {
            dimension: set.dimension,
            min: states(info, set.low.clone()),
            max: states(info, set.high.clone()),
        };
        Self {
            r: one.r,
            parameters: parameters(info, &one.parameters),
            state: states(info, one.state.clone()),
            eigenvalues: pairs(&one.eigenvalues),
            stability: one.stability.name(),
            mode: one.mode.as_deref(),
            set: one.set.as_ref().map(set),
            artefact: one.artefact,
            certificate: None,
        }
    }
}

impl<'a> Special<'a> {
    fn new(info: &'a ModelInfo, point: &'a SpecialEquilibrium) -> Self {
        Self {
            kind: point.kind,
            label: &point.label,
            r: point.r,
            state: states(info, point.state.clone()),
            eigenvalues: pairs(&point.eigenvalues),
            period: point.period,
            artefact: point.artefact,
        }
    }
}
