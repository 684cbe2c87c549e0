//! The tangent of a branch: the null vector of [h_z h_r], from a bordered solve.

use nalgebra::DVector;

use super::Linearisation;
use super::corrector::bordered;
use crate::linear::solved;

/// The unit tangent in scaled coordinates (r last) that forms an acute angle with `before`: (2.13) to (2.16).
///
/// The border row is the previous tangent, so that folds are regular points. `None` if the bordered
/// matrix is singular.
pub(crate) fn tangent<Extra>(
    linearisation: &Linearisation<Extra>,
    scale: &DVector<f64>,
    r_scale: f64,
    before: &DVector<f64>,
) -> Option<DVector<f64>> {
    let n = scale.len();
    let mut right = DVector::zeros(n + 1);
    right[n] = 1.0;
    let tangent = solved(&bordered(linearisation, scale, r_scale, before), &right)?;
    let length = tangent.norm();
    (length.is_finite() && length > 0.0).then(|| tangent / length)
}
