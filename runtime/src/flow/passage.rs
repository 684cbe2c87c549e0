//! What is told of a motion, its states and matrices arrays of a known size, or of any.

use serde::{Deserialize, Serialize};

use super::{Determinant, EventKind};
use crate::field::exact::Mode;

/// The field at a place, with its derivatives where the motion continues.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Velocity<V, M> {
    /// f.
    pub f: V,
    /// ∂fᵢ/∂yⱼ.
    pub jacobian: M,
    /// ∂f/∂r.
    pub design: V,
    /// How many internal states rest on their stops: their rows of the Jacobian are zero.
    pub lost: usize,
}

/// How the end of a passage depends on its beginning, on the design variable and on its duration.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Derivatives<V, M> {
    /// Φ = ∂φ/∂y.
    pub state: M,
    /// ∂φ/∂r.
    pub design: V,
    /// ∂φ/∂t: the velocity at the end.
    pub time: V,
    /// det Φ: Liouville's ∫ tr J dt over the smooth stretches, and what each event adds to it.
    pub determinant: Determinant,
    /// Factors of Φ = Fₘ ⋯ F₁ in the order of time, if wanted.
    pub factors: Vec<Factor<M>>,
    /// The most internal states that rested on their stops at once: as many multipliers of an orbit are exactly zero.
    pub lost: usize,
}

/// A factor of Φ over one stretch of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Factor<M> {
    /// ∂(end)/∂(beginning) of the stretch.
    pub state: M,
    /// ∫ J dt over the stretch, where an implicit step damps what decays fast far less than the motion does.
    pub growth: Option<M>,
}

/// A local extremum of one state along a motion.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Extremum<S> {
    /// Which state.
    pub index: usize,
    /// Whether it is a maximum.
    pub maximum: bool,
    /// When, from the beginning of the passage.
    pub time: f64,
    /// The whole state there.
    pub state: S,
}

/// A state on a motion.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Sample<S> {
    /// Time from the beginning of the passage.
    pub time: f64,
    /// State at that time.
    pub state: S,
}

/// A node of a quadrature over a motion: the integral of a function is the sum of its values, each times its weight.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Node<S> {
    /// Time from the beginning of the passage.
    pub time: f64,
    /// Weight, in units of time.
    pub weight: f64,
    /// State at that time.
    pub state: S,
}

/// Something that happened at a contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Event<S> {
    /// What.
    pub kind: EventKind,
    /// Number of the contact.
    pub contact: usize,
    /// Mode of the contact afterwards.
    pub mode: Mode,
    /// When, from the beginning of the passage.
    pub time: f64,
    /// The whole state there.
    pub state: S,
    /// Rate at which the guard of the contact fell; 0 where it only came near, or where others made it switch.
    pub rate: f64,
}

impl<S> Event<S> {
    /// Whether the mode of a contact changes, or that of a press may.
    #[must_use]
    pub fn switches(&self) -> bool {
        self.kind.is_switch() || self.mode.is_of_press()
    }
}
