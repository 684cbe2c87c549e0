//! A vector field with its first derivatives, and the eigenvalues of matrices.

use nalgebra::{Complex, DMatrix, Schur};

/// A field and its first derivatives at one state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Linear<const N: usize> {
    /// f.
    pub f: [f64; N],
    /// ∂fᵢ/∂yⱼ in row i and column j.
    pub jacobian: [[f64; N]; N],
    /// ∂f/∂r.
    pub design: [f64; N],
}

impl<const N: usize> Linear<N> {
    /// Trace of the Jacobian: the rate at which volumes grow (Liouville).
    #[must_use]
    pub fn trace(&self) -> f64 {
        (0..N).map(|i| self.jacobian[i][i]).sum()
    }
}

/// Eigenvalues of a square matrix; none if the QR iteration does not end.
pub(crate) fn eigenvalues(matrix: &DMatrix<f64>) -> Vec<Complex<f64>> {
    match matrix.nrows() {
        0 => Vec::new(),
        1 => vec![Complex::new(matrix[(0, 0)], 0.0)],
        _ => Schur::try_new(matrix.clone(), f64::EPSILON, 10_000)
            .map(|schur| schur.complex_eigenvalues().iter().copied().collect())
            .unwrap_or_default(),
    }
}
