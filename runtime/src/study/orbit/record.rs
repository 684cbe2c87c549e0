//! What is reported of a periodic orbit.

use super::held::Held;
use crate::bifurcation::Floquet;
use crate::field::Work;
use crate::flow::FlowError;
use crate::harmonics::Harmonic;
use crate::motion::Modes;
use crate::shooting::{Certificate, Uncertified};
use crate::study::question::Dynamics;

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
    /// The modes in which it begins there; none for a smooth system.
    pub modes: Modes,
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
    /// What the states gain once around, where it runs on: a shift that changes nothing.
    pub shift: Option<Vec<f64>>,
    /// Multipliers and what they say.
    pub floquet: Floquet,
    /// What is held in neutral directions, in which orbits beside it are orbits too.
    pub held: Vec<Held>,
    /// Its harmonics, those that the case asks for.
    pub harmonics: Result<Vec<Harmonic>, FlowError>,
    /// The modes that it runs through, for exact dynamics.
    pub word: Option<String>,
    /// Norm of the shooting residual, relative to the extents of the states.
    pub residual: f64,
    /// Estimated relative error of period and extrema.
    pub error_estimate: f64,
    /// The same a little further along its branch, where that is known.
    pub beside: Option<Beside>,
    /// What it cost.
    pub work: Work,
}

/// What is reported of an orbit a little further along its branch, to first order: how things change there.
#[derive(Debug, Clone, PartialEq)]
pub struct Beside {
    /// The design variable, in the user's own values.
    pub r: f64,
    /// The period.
    pub period: f64,
    /// Largest value of each state.
    pub max: Vec<f64>,
    /// Smallest value of each state.
    pub min: Vec<f64>,
    /// Its points on the default section, in the order of those of the orbit.
    pub section: Vec<Vec<f64>>,
    /// Its harmonics; none where their phases would be counted from elsewhere.
    pub harmonics: Vec<Harmonic>,
}

impl OrbitRecord {
    /// The orbit a little further along its branch as far as it is known: its design variable, period, extent, section and
    /// harmonics. It has no multipliers.
    #[must_use]
    pub fn further(&self) -> Option<Self> {
        let beside = self.beside.clone()?;
        let largest = |(low, high): (&f64, &f64)| low.abs().max(high.abs());
        let mut further = self.clone();
        further.floquet.multipliers.clear();
        further.floquet.log_moduli.clear();
        Some(Self {
            r: Some(beside.r),
            period: beside.period,
            max_abs: beside.min.iter().zip(&beside.max).map(largest).collect(),
            max: beside.max,
            min: beside.min,
            section: beside.section,
            harmonics: Ok(beside.harmonics),
            beside: None,
            ..further
        })
    }
}

/// An orbit with its certificate, or with the reason for which it has none.
#[derive(Debug, Clone, PartialEq)]
pub struct CertifiedOrbit {
    /// The orbit, certified or not.
    pub orbit: OrbitRecord,
    /// How near to it a true orbit is.
    pub certificate: Result<Certificate, Uncertified>,
}
