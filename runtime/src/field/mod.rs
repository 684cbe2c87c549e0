//! Vector fields: all that an integrator sees of a model.

mod count;
pub mod exact;

pub use count::Work;

use crate::integrate::Tolerance;

/// An autonomous vector field of order `N` with one design variable r.
///
/// Methods ask for the lowest rung they need: a simulation never asks for a Jacobian.
pub trait Field<const N: usize> {
    /// `Some(j)` in place i where ẏᵢ = yⱼ exactly: rows that an implicit method eliminates.
    const KINEMATIC: [Option<usize>; N] = [None; N];

    /// f(y).
    fn f(&self, y: &[f64; N]) -> [f64; N];

    /// f, its Jacobian and ∂f/∂r together.
    fn linearise(&self, y: &[f64; N]) -> Linear<N>;

    /// The largest error of a sliding speed relative to what its friction layer tolerates, for the
    /// error `error` of the state; 0 for a field without layers.
    fn layer_error(&self, _y: &[f64; N], _error: &[f64; N], _tolerance: &Tolerance) -> f64 {
        0.0
    }

    /// Number of surfaces on which the field is continuous but not smooth; steps are split there.
    fn kinks(&self) -> usize {
        0
    }

    /// A function of the state that changes sign on kink surface number `index`.
    fn kink(&self, _index: usize, _y: &[f64; N]) -> f64 {
        1.0
    }
}

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
