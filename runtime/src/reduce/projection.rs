//! Matrices seen by a few shapes.

use nalgebra::DMatrix;

use super::pencil::Pencil;

/// Eigenvalues, shapes of modal mass 1, and the flexibility of the points that these leave out.
pub(super) struct Reduced {
    pub(super) values: Vec<f64>,
    pub(super) shapes: DMatrix<f64>,
    pub(super) residual: DMatrix<f64>,
}

/// `Xᵀ A X`
pub(super) fn projected(pencil: &Pencil, values: &[f64], x: &DMatrix<f64>) -> DMatrix<f64> {
    let product = x.tr_mul(&pencil.times(values, x.as_view()));
    (&product + product.transpose()) / 2.0
}
