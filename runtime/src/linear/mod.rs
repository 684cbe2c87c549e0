//! A vector field with its first derivatives; the eigenvalues of matrices with their errors, and their singular values.

mod balance;
mod eigenvalue;
mod elimination;
mod schur;
mod svd;

pub(crate) use balance::{balanced, units};
pub(crate) use eigenvalue::{Eigenvalue, eigenvalues};
pub(crate) use elimination::{orientation, solved};
pub(crate) use svd::svd;

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
