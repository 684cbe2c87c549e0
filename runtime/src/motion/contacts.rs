//! What set-valued contacts do at a place, each number with its slopes.

use nalgebra::{DMatrix, DVector};

/// A number and its derivatives with respect to the states and the design variable.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The number.
    pub value: f64,
    /// Its derivatives.
    pub slopes: Vec<f64>,
    /// Its derivative with respect to the design variable.
    pub design: f64,
}

/// One contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// Relative speed w.
    pub speed: Row,
    /// Friction force λ as it stands in the equations; where the contact sticks, the force that holds it.
    pub force: Row,
    /// Largest force at rest.
    pub stick: Row,
}

/// The field at a place, and every contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Contacts {
    /// f.
    pub f: DVector<f64>,
    /// ∂fᵢ/∂yⱼ, contacts that stick held by their forces.
    pub jacobian: DMatrix<f64>,
    /// Every contact in the order of declaration; none for a smooth system.
    pub all: Vec<Contact>,
}
