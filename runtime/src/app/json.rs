//! Answers as JSON.

mod certificate;
mod curve;
mod diagram;
mod equilibrium;
mod motion;
mod section;
mod trade;
mod work;

use serde::ser::{Serialize, Serializer};

use super::text::time_unit;
use certificate::OrbitCertificate;
pub(super) use curve::CurveDocument;
pub(super) use diagram::DiagramDocument;
pub(super) use equilibrium::{Equilibria, EquilibriumBranch};
pub(super) use motion::Motion;
pub(super) use section::Crossings;
pub(super) use trade::Trade;
use work::Counts;

use crate::field::Work;
use crate::model::{ModelInfo, Unit};
use crate::shooting::{Certificate, Uncertified};
use crate::study::{Along, BranchRecord, Case, OrbitRecord, Special};

/// Values by name, in the order of declaration.
pub(super) struct Named<'a, T>(Vec<(&'a str, T)>);

impl<'a, T> Named<'a, T> {
    pub(super) fn new(
        names: impl Iterator<Item = &'a str>,
        values: impl IntoIterator<Item = T>,
    ) -> Self {
        Self(names.zip(values).collect())
    }
}

impl<T: Serialize> Serialize for Named<'_, T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

fn states<'a, T>(info: &'a ModelInfo, values: impl IntoIterator<Item = T>) -> Named<'a, T> {
    Named::new(info.states.iter().map(|state| state.name), values)
}

fn parameters<'a>(info: &'a ModelInfo, values: &[f64]) -> Named<'a, f64> {
    Named::new(
        info.parameters.iter().map(|declared| declared.name),
        values.to_vec(),
    )
}

/// The units of states, parameters, friction forces and observables, and of time.
pub(super) fn units(info: &ModelInfo) -> Named<'_, &'static str> {
    let states = info.states.iter().map(|state| (state.name, state.unit));
    let parameters = info
        .parameters
        .iter()
        .map(|declared| (declared.name, declared.unit));
    let forces = info
        .contacts
        .iter()
        .map(|contact| (contact.name, contact.unit));
    let observables = info.observables.iter().map(|line| (line.name, line.unit));
    let known = |(name, unit): (&'static str, Option<Unit>)| Some((name, unit?.text));
    let named = states.chain(parameters).chain(forces).chain(observables);
    let mut units: Vec<(&str, &str)> = named.filter_map(known).collect();
    let times = [
        ("time", "s"),
        ("period", "s"),
        ("frequency", "1/s"),
        ("eigenvalues", "1/s"),
    ];
    if !time_unit(info).is_empty() {
        let taken = |name| units.iter().any(|(known, _)| *known == name);
        let free: Vec<_> = times
            .into_iter()
            .filter(|(name, _)| !taken(*name))
            .collect();
        units.extend(free);
    }
    Named(units)
}

/// A periodic orbit.
#[derive(serde::Serialize)]
pub(super) struct Orbit<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    r: Option<f64>,
    model: &'a str,
    dynamics: String,
    parameters: Named<'a, f64>,
    period: f64,
    frequency: f64,
    state: Named<'a, f64>,
    max: Named<'a, f64>,
    min: Named<'a, f64>,
    max_abs: Named<'a, f64>,
    period_count: usize,
    multipliers: Vec<[f64; 2]>,
    log_abs_multipliers: &'a [Option<f64>],
    /// Nothing with a drive: there is no trivial multiplier.
    trivial_multiplier_error: Option<f64>,
    stability: &'static str,
    word: Option<&'a str>,
    units: Named<'a, &'static str>,
    residual: f64,
    error_estimate: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    method: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    section: Option<Crossings<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    certificate: Option<OrbitCertificate<'a>>,
    work: Counts,
}

impl<'a> Orbit<'a> {
    /// The same with the method that was chosen, and why.
    pub(super) fn with_method(mut self, reason: String) -> Self {
        self.method = Some(reason);
        self
    }

    /// The same with its points on a section.
    pub(super) fn with_section(mut self, section: Option<Crossings<'a>>) -> Self {
        self.section = section;
        self
    }

    /// The same with its certificate, or why it has none, if one was asked for.
    pub(super) fn with_certificate(
        mut self,
        info: &'a ModelInfo,
        certificate: Option<&'a Result<Certificate, Uncertified>>,
    ) -> Self {
        self.certificate = certificate.map(|found| OrbitCertificate::new(info, found));
        self
    }

    pub(super) fn new(info: &'a ModelInfo, orbit: &'a OrbitRecord) -> Self {
        let named = |values: &[f64]| states(info, values.to_vec());
        Self {
            r: orbit.r,
            model: info.command,
            dynamics: orbit.dynamics.to_string(),
            parameters: parameters(info, &orbit.parameters),
            period: orbit.period,
            frequency: 1.0 / orbit.period,
            state: named(&orbit.state),
            max: named(&orbit.max),
            min: named(&orbit.min),
            max_abs: named(&orbit.max_abs),
            period_count: orbit.period_count,
            multipliers: orbit
                .floquet
                .multipliers
                .iter()
                .map(|m| [m.re, m.im])
                .collect(),
            log_abs_multipliers: &orbit.floquet.log_moduli,
            trivial_multiplier_error: info.drive.is_none().then_some(orbit.floquet.trivial_error),
            stability: orbit.floquet.stability.name(),
            word: orbit.word.as_deref(),
            units: units(info),
            residual: orbit.residual,
            error_estimate: orbit.error_estimate,
            method: None,
            section: None,
            certificate: None,
            work: Counts::from(&orbit.work),
        }
    }
}

/// A branch of periodic orbits.
#[derive(serde::Serialize)]
pub(super) struct Branch<'a> {
    model: &'a str,
    dynamics: String,
    parameters: Named<'a, f64>,
    along: Range<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    from: Option<&'a str>,
    points: Vec<Orbit<'a>>,
    special: Vec<Point<'a>>,
    ended: &'static str,
    reason: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    began: Option<&'static str>,
    branches: Vec<Branch<'a>>,
    units: Named<'a, &'static str>,
    work: Counts,
}

/// What is followed, from where to where.
#[derive(serde::Serialize)]
struct Range<'a> {
    name: &'a str,
    from: f64,
    to: f64,
}

impl<'a> Range<'a> {
    fn new(info: &'a ModelInfo, along: &Along) -> Self {
        Self {
            name: along.name(info),
            from: along.from,
            to: along.to,
        }
    }
}

/// A special point.
#[derive(serde::Serialize)]
struct Point<'a> {
    kind: &'static str,
    label: &'a str,
    r: f64,
    period: f64,
    multipliers: Vec<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    criticality: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<&'a str>,
}

impl<'a> Point<'a> {
    fn new(special: &'a Special) -> Self {
        Self {
            kind: special.kind,
            label: &special.label,
            r: special.r,
            period: special.period,
            multipliers: special.multipliers.iter().map(|m| [m.re, m.im]).collect(),
            criticality: special.criticality,
            note: special.note.as_deref(),
        }
    }
}

impl<'a> Branch<'a> {
    pub(super) fn new(info: &'a ModelInfo, case: &Case, branch: &'a BranchRecord) -> Self {
        let along = &branch.along;
        let mut work = Work::default();
        branch.points.iter().for_each(|point| work += point.work);
        Self {
            model: info.command,
            dynamics: case.dynamics.to_string(),
            parameters: parameters(info, &case.parameters),
            along: Range::new(info, along),
            points: branch
                .points
                .iter()
                .map(|point| Orbit::new(info, point))
                .collect(),
            special: branch.special.iter().map(Point::new).collect(),
            from: branch.from.as_deref(),
            ended: branch.ended.word(),
            reason: &branch.ended.reason,
            began: branch.began.as_ref().map(|ended| ended.word()),
            branches: branch
                .branches
                .iter()
                .map(|branch| Branch::new(info, case, branch))
                .collect(),
            units: units(info),
            work: Counts::from(&work),
        }
    }
}
