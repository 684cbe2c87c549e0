//! Points of a branch in terms of its unknowns.

use std::sync::Arc;

use nalgebra::DVector;

use super::Linearisation;

/// An accepted point of a branch.
#[derive(Debug, Clone)]
pub struct Point<Extra> {
    /// Unknowns.
    pub z: DVector<f64>,
    /// Design variable.
    pub r: f64,
    /// What the problem says of it.
    pub extra: Extra,
    /// Norm of the residual.
    pub residual: f64,
    /// Unit tangent in scaled coordinates, r last: that component changes sign at a fold.
    pub tangent: DVector<f64>,
    /// The magnitude of r in these coordinates.
    pub r_scale: f64,
    /// Newton iterations spent.
    pub newton: u64,
}

impl<Extra> Point<Extra> {
    /// The tangent in the units of the unknowns and of r, where the unknowns have these magnitudes.
    #[must_use]
    pub fn way(&self, scale: &DVector<f64>) -> DVector<f64> {
        self.tangent.component_mul(&scale.push(self.r_scale))
    }
}

/// The point from which the next step is made, in unscaled coordinates.
#[derive(Debug, Clone)]
pub(super) struct Base<Extra> {
    pub(super) z: DVector<f64>,
    pub(super) r: f64,
    pub(super) tangent: DVector<f64>,
    /// The equations there.
    pub(super) linearisation: Arc<Linearisation<Extra>>,
}

impl<Extra: Clone> Base<Extra> {
    /// Whether r first goes away from this value.
    pub(super) fn leads_from(&self, r: f64) -> bool {
        self.tangent[self.z.len()] * (r - self.r) < 0.0
    }

    /// The same point, from which steps go the other way.
    pub(super) fn turned(&self) -> Self {
        Self {
            tangent: -&self.tangent,
            ..self.clone()
        }
    }
}

/// A tangent in coordinates that are stretched by `ratio`, and in r by another one.
pub(super) fn rescaled(
    mut tangent: DVector<f64>,
    ratio: &DVector<f64>,
    r_ratio: f64,
) -> DVector<f64> {
    let n = ratio.len();
    tangent.rows_mut(0, n).component_mul_assign(ratio);
    tangent[n] *= r_ratio;
    tangent.normalize()
}

/// The direction of r alone, beside n unknowns.
pub(super) fn unit(n: usize) -> DVector<f64> {
    let mut normal = DVector::zeros(n + 1);
    normal[n] = 1.0;
    normal
}
