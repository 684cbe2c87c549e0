//! One periodic orbit, and all that is reported of it.

use super::case::{Case, Dynamics};
use super::seed::Seed;
use crate::bifurcation::{Floquet, Kind, Located};
use crate::field::Work;
use crate::flow::{Family, Flow, Segment};
use crate::shooting::{
    Certificate, Guess, Orbit, OrbitError, Search, Uncertified, certify, closest,
};

type Mode<F, const N: usize> = <<F as Family<N>>::Flow as Flow<N>>::Mode;

/// A periodic orbit as it is reported, whatever model it belongs to.
#[derive(Debug, Clone, PartialEq)]
pub struct OrbitRecord {
    /// The design variable, if one is followed, in the user's own values.
    pub r: Option<f64>,
    /// Values of all parameters.
    pub parameters: Vec<f64>,
    /// How friction acts.
    pub dynamics: Dynamics,
    /// Its start, on the default section where the orbit has a minimum of the first state.
    pub state: Vec<f64>,
    /// Its minimal period.
    pub period: f64,
    /// Largest value of each state.
    pub max: Vec<f64>,
    /// Smallest value of each state.
    pub min: Vec<f64>,
    /// Largest magnitude of each state.
    pub max_abs: Vec<f64>,
    /// Crossings of the default section in one period.
    pub period_count: usize,
    /// Its points on the default section, in the order of time.
    pub section: Vec<Vec<f64>>,
    /// Multipliers and what they say.
    pub floquet: Floquet,
    /// The modes that it runs through, for exact dynamics.
    pub word: Option<String>,
    /// Norm of the shooting residual, relative to the extents of the states.
    pub residual: f64,
    /// Estimated relative error of period and extrema.
    pub error_estimate: f64,
    /// What it cost.
    pub work: Work,
}

/// An orbit with its certificate, or with the reason for which it has none.
#[derive(Debug, Clone, PartialEq)]
pub struct CertifiedOrbit {
    /// The orbit, certified or not.
    pub orbit: OrbitRecord,
    /// How near to it a true orbit is.
    pub certificate: Result<Certificate, Uncertified>,
}

/// How much a failure tells of the system: that motions settle elsewhere is more than that a search ended.
fn tells(error: &OrbitError) -> u8 {
    match error {
        OrbitError::NotIsolated { .. } => 3,
        OrbitError::Equilibrium { .. } => 2,
        OrbitError::NotSettled { .. } => 1,
        OrbitError::Newton(_) | OrbitError::Flow(_) => 0,
    }
}

/// How the stretches of an orbit are spelt.
pub(super) type Spelling<Mode> = fn(&[Segment<Mode>]) -> Option<String>;

/// A family with what is sought in it.
pub(super) struct Sought<'a, F: Family<N>, const N: usize> {
    pub(super) family: &'a F,
    pub(super) case: &'a Case,
    /// Tried in this order.
    pub(super) seeds: Vec<Seed<N>>,
    pub(super) search: Search<N>,
    pub(super) spelling: Spelling<Mode<F, N>>,
}

impl<F: Family<N> + Clone, const N: usize> Sought<'_, F, N> {
    /// Tells a branch point from one at which a symmetry is lost.
    pub(super) fn tell_symmetry(&self, found: &mut Located<Orbit<N, Mode<F, N>>>) {
        // An orbit that cannot be gone around once more has no symmetry that could be told.
        if found.kind == Kind::BranchPoint && found.point.loses_symmetry(self.family) == Ok(true) {
            found.kind = Kind::SymmetryBreaking;
        }
    }

    /// The orbit at r, in the family's own count, from the first seed that leads to one.
    pub(super) fn orbit(&self, r: f64) -> Result<Orbit<N, Mode<F, N>>, OrbitError> {
        let mut telling = None::<OrbitError>;
        for &Seed { start, period } in &self.seeds {
            let search = Search {
                start,
                period,
                ..self.search
            };
            match closest(self.family, r, &search) {
                Ok(orbit) => return Ok(orbit),
                Err(error) if telling.as_ref().is_none_or(|t| tells(t) <= tells(&error)) => {
                    telling = Some(error);
                }
                Err(_) => {}
            }
        }
        Err(telling.unwrap_or(OrbitError::NotSettled {
            time: 0.0,
            last: None,
        }))
    }

    /// The orbit at r as it is reported.
    pub(super) fn found(&self, r: f64) -> Result<OrbitRecord, OrbitError> {
        Ok(self.record(&self.orbit(r)?))
    }

    /// The orbit at r as it is reported, with its certificate.
    pub(super) fn certified(&self, r: f64) -> Result<CertifiedOrbit, OrbitError> {
        let orbit = self.orbit(r)?;
        let found = Guess {
            place: orbit.heading.start,
            period: orbit.period,
            magnitude: orbit.magnitude(),
        };
        Ok(CertifiedOrbit {
            certificate: certify(self.family, r, &found, self.search.accuracy),
            orbit: self.record(&orbit),
        })
    }

    /// The orbit as it is reported.
    pub(super) fn record(&self, orbit: &Orbit<N, Mode<F, N>>) -> OrbitRecord {
        let r = self.case.along.map(|along| along.value(orbit.r));
        let case = r.map_or_else(|| self.case.clone(), |r| self.case.at(r));
        OrbitRecord {
            r,
            parameters: case.parameters,
            dynamics: case.dynamics,
            state: orbit.place.state.to_vec(),
            period: orbit.period,
            max: orbit.max.to_vec(),
            min: orbit.min.to_vec(),
            max_abs: orbit.max_abs().to_vec(),
            period_count: orbit.period_count,
            section: orbit.section.iter().map(|state| state.to_vec()).collect(),
            floquet: orbit.floquet.clone(),
            word: (self.spelling)(&orbit.segments),
            residual: orbit.residual,
            error_estimate: orbit.error_estimate,
            work: orbit.work,
        }
    }
}
