//! A point of a curve.

use crate::bifurcation::Floquet;
use crate::shooting::Orbit;

/// An orbit that is special, and where.
#[derive(Debug, Clone)]
pub struct CurvePoint {
    /// The first design variable.
    pub p: f64,
    /// The second one.
    pub q: f64,
    /// The orbit; its residual includes that of the condition.
    pub orbit: Orbit,
    /// The condition that makes it special, as it was met.
    pub test: f64,
    /// Components of the unit tangent along p and q, in scaled coordinates.
    pub tangent: [f64; 2],
}

impl CurvePoint {
    /// Stability.
    #[must_use]
    pub fn floquet(&self) -> &Floquet {
        &self.orbit.floquet
    }
}
