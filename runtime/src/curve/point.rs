//! A point of a curve.

use crate::bifurcation::Floquet;
use crate::continuation::Watched;
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
    /// Which of p and q, the first or the second, stands still here along the curve, if it was found because one does.
    pub still: Option<usize>,
}

impl CurvePoint {
    /// Stability.
    #[must_use]
    pub fn floquet(&self) -> &Floquet {
        &self.orbit.floquet
    }
}

impl Watched for CurvePoint {
    fn r(&self) -> f64 {
        self.q
    }

    fn slope(&self) -> f64 {
        self.tangent[1]
    }

    fn moved(&self, from: &Self) -> f64 {
        moved([self.p, self.q], [from.p, from.q])
    }
}

/// How far a point moves in both variables, relative to their values.
pub(super) fn moved(to: [f64; 2], from: [f64; 2]) -> f64 {
    let relative = to
        .iter()
        .zip(from)
        .map(|(to, from)| ((to - from) / to).abs());
    relative.fold(0.0, f64::max)
}
