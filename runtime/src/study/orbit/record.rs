//! What is reported of a periodic orbit.

use crate::bifurcation::Floquet;
use crate::field::Work;
use crate::model::ModelInfo;
use crate::shooting::{Certificate, Pin, Uncertified};
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
    /// What is held in neutral directions, in which orbits beside it are orbits too.
    pub held: Vec<Held>,
    /// The modes that it runs through, for exact dynamics.
    pub word: Option<String>,
    /// Norm of the shooting residual, relative to the extents of the states.
    pub residual: f64,
    /// Estimated relative error of period and extrema.
    pub error_estimate: f64,
    /// What it cost.
    pub work: Work,
}

/// A condition on the start of an orbit that singles it out among its neighbours.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "app", derive(serde::Serialize))]
pub struct Held {
    /// A combination of the states, in their names.
    pub combination: String,
    /// Its value where the orbit begins.
    pub value: f64,
    /// Whether it never changes along the orbit; otherwise the orbit may be shifted along it.
    pub conserved: bool,
}

impl Held {
    /// The condition in the names of the model.
    pub(in crate::study) fn new(pin: &Pin, info: &ModelInfo) -> Self {
        let entries = pin.combination.iter().zip(info.states);
        let terms = entries.filter(|(c, _)| **c != 0.0);
        let mut combination = String::new();
        for (c, state) in terms {
            let sign = match (combination.is_empty(), *c < 0.0) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            let size = match c.abs() {
                size if (size - 1.0).abs() < 1e-6 => String::new(),
                size => format!("{} ", (size * 1e6).round() / 1e6),
            };
            combination += &format!("{sign}{size}{}", state.name);
        }
        Self {
            combination,
            value: pin.value,
            conserved: pin.conserved,
        }
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
