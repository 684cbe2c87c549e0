//! One periodic orbit, and all that is reported of it.

use super::case::{Case, Dynamics};
use super::error::StudyError;
use super::sought::Sought;
use super::system::System;
use crate::bifurcation::Floquet;
use crate::field::Work;
use crate::motion::word;
use crate::shooting::{Certificate, Guess, Orbit, Uncertified, certify};

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

impl System {
    /// The periodic orbit that is reached from the start of the case.
    ///
    /// # Errors
    /// None was found.
    pub fn orbit(&self, case: &Case) -> Result<OrbitRecord, StudyError> {
        let sought = self.sought(case)?;
        let orbit = sought.orbit(self.beginning(case));
        let orbit = orbit.map_err(|error| self.sharpened(case, error))?;
        Ok(sought.record(&orbit))
    }

    /// The same orbit with its certificate: how near to it a true orbit is, and only one.
    ///
    /// # Errors
    /// None was found. An orbit that cannot be certified is no error: it comes with the reason.
    pub fn certified_orbit(&self, case: &Case) -> Result<CertifiedOrbit, StudyError> {
        let (sought, r) = (self.sought(case)?, self.beginning(case));
        let orbit = sought.orbit(r);
        let orbit = orbit.map_err(|error| self.sharpened(case, error))?;
        let found = Guess {
            place: orbit.heading.start.clone(),
            period: orbit.period,
            magnitude: orbit.magnitude(),
        };
        Ok(CertifiedOrbit {
            certificate: certify(&sought.family, r, &found, case.accuracy),
            orbit: sought.record(&orbit),
        })
    }
}

impl Sought<'_> {
    /// The orbit as it is reported.
    pub(super) fn record(&self, orbit: &Orbit) -> OrbitRecord {
        let r = self.case.along.map(|along| along.value(orbit.r));
        let case = r.map_or_else(|| self.case.clone(), |r| self.case.at(r));
        let rubs = self.system.rubs(self.case);
        OrbitRecord {
            r,
            parameters: case.parameters,
            dynamics: case.dynamics,
            state: orbit.place.state.clone(),
            period: orbit.period,
            max: orbit.max.clone(),
            min: orbit.min.clone(),
            max_abs: orbit.max_abs(),
            period_count: orbit.period_count,
            section: orbit.section.clone(),
            floquet: orbit.floquet.clone(),
            word: rubs.then(|| word(self.system.info(), &orbit.segments)),
            residual: orbit.residual,
            error_estimate: orbit.error_estimate,
            work: orbit.work,
        }
    }
}
