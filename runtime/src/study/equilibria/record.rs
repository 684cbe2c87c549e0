//! Equilibria, and all that is reported of them.

use nalgebra::Complex;
use serde::Serialize;

use crate::bifurcation::Stability;
use crate::continuation::Kind;
use crate::field::Work;
use crate::study::ended::Ended;
use crate::study::question::{Along, Dynamics};

/// An equilibrium, or a set of sticking ones, as it is reported, whatever model it belongs to.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EquilibriumRecord {
    /// The design variable, if one is followed, in the user's own values.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub r: Option<f64>,
    /// Values of all parameters.
    #[cfg_attr(feature = "app", serde(skip))]
    pub parameters: Vec<f64>,
    /// How friction acts.
    #[serde(skip)]
    pub dynamics: Dynamics,
    /// Where; for a set, a state in it.
    pub state: Vec<f64>,
    /// Eigenvalues, largest real part first; of a set, those that lead away from it while its contacts stick.
    pub eigenvalues: Vec<Complex<f64>>,
    /// What they say.
    pub stability: Stability,
    /// The mode of each contact, for exact dynamics.
    pub mode: Option<String>,
    /// How far a set reaches; `None` for a single state.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub set: Option<Extent>,
    /// Whether only the smooth copy has it like this: the exact system has none there, or one of other stability.
    pub artefact: bool,
    /// On a branch, the design variable and the state a little further along it, to first order.
    #[serde(skip)]
    pub beside: Option<(f64, Vec<f64>)>,
}

/// How far a set of sticking equilibria reaches.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Extent {
    /// How many directions it has: 1 for an interval.
    pub dimension: usize,
    /// Smallest value of each state.
    #[serde(rename = "min")]
    pub low: Vec<f64>,
    /// Largest value of each state.
    #[serde(rename = "max")]
    pub high: Vec<f64>,
}

/// A point of a branch of equilibria where something changes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SpecialEquilibrium {
    /// What changes: `fold`, `hopf`, `flutter`, `branch-point` or `boundary-equilibrium`.
    pub kind: Kind,
    /// Kind and number, for instance `HB1`.
    pub label: String,
    /// How many points of its branch precede it.
    #[cfg_attr(feature = "app", serde(skip))]
    pub after: usize,
    /// The design variable, in the user's own values.
    pub r: f64,
    /// Its estimated error; none where that could not be measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<f64>,
    /// Where.
    pub state: Vec<f64>,
    /// Eigenvalues there.
    pub eigenvalues: Vec<Complex<f64>>,
    /// Period of the small orbits that begin at a Hopf point, or of the vibration that grows from flutter.
    pub period: Option<f64>,
    /// The first Lyapunov coefficient of a Hopf point, with an eigenvector of length 1; none where it is not known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub l1: Option<f64>,
    /// Its estimated error.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub l1_error: Option<f64>,
    /// Whether periodic motions begin there `soft` or `hard`, as far as that coefficient tells.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub onset: Option<&'static str>,
    /// Whether only the smooth copy has it.
    pub artefact: bool,
}

/// A branch of equilibria as it is reported.
#[derive(Debug, Clone, PartialEq)]
pub struct EquilibriaRecord {
    /// What was followed.
    pub along: Along,
    /// Its points in the order in which they were found.
    pub points: Vec<EquilibriumRecord>,
    /// Where something changes.
    pub special: Vec<SpecialEquilibrium>,
    /// The equilibria at the value with which it begins that are none of its points: others may be followed from there.
    pub others: Vec<EquilibriumRecord>,
    /// Why it ended.
    pub ended: Ended,
    /// What it cost.
    pub work: Work,
}
