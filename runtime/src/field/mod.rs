//! Vector fields: all that an integrator sees of a model.

mod count;
mod enclosed;
pub mod exact;
mod form;
mod generic;
mod linear;
mod memory;
mod smooth;
mod smoothing;
mod stops;
mod strip;

pub use crate::linear::Linear;
pub use count::Work;
pub use enclosed::{Enclosed, EnclosedField, Unenclosed};
pub(crate) use form::Form;
pub(crate) use generic::{GENERIC, generic_state};
pub(crate) use linear::{LinearField, Point};
pub use smooth::{Design, SmoothField};
pub(crate) use smoothing::Smoothed;
pub use smoothing::{Kernel, Smoothing, SmoothingError};
pub(crate) use stops::{Caught, Frictionless, Settled, Stops};
pub(crate) use strip::Strip;

use crate::integrate::Tolerance;

/// An autonomous vector field of order `N` with one design variable r.
///
/// Methods ask for the lowest rung they need: a simulation never asks for a Jacobian.
pub trait Field<const N: usize> {
    /// `Some(j)` in place i where ẏᵢ = yⱼ exactly: rows that an implicit method eliminates.
    const KINEMATIC: [Option<usize>; N] = [None; N];

    /// f(y).
    fn f(&self, y: &[f64; N]) -> [f64; N];

    /// Hands f(y) to `take`, where it is made: a field with several ways to make it would copy what comes out of them.
    #[inline(always)]
    fn with_f<R>(&self, y: &[f64; N], take: impl FnOnce([f64; N]) -> R) -> R {
        take(self.f(y))
    }

    /// f, its Jacobian and ∂f/∂r together.
    fn linearise(&self, y: &[f64; N]) -> Linear<N>;

    /// Hands the same to `take`, as [`Field::with_f`] does.
    #[inline(always)]
    fn with_linear<R>(&self, y: &[f64; N], take: impl FnOnce(Linear<N>) -> R) -> R {
        take(self.linearise(y))
    }

    /// What the error of each component is measured against at `y`; a friction layer tightens it.
    fn scale(&self, y: &[f64; N], tolerance: &Tolerance) -> [f64; N] {
        y.map(|component| tolerance.absolute + tolerance.relative * component.abs())
    }

    /// Whether a step between these states may have carried the motion out of a thin layer that holds it.
    ///
    /// A stiff step that jumps such a layer solves its equations all the same, and its error estimate, damped by the
    /// layer's own stiffness, does not see it.
    fn leaps(&self, _from: &[f64; N], _to: &[f64; N]) -> bool {
        false
    }

    /// Number of surfaces on which the field is continuous but not smooth; steps are split there.
    fn kinks(&self) -> usize {
        0
    }

    /// How many of them, the first ones, are corners of the field itself and not of a friction layer: explicit steps,
    /// which resolve a layer anyway, are split there too.
    fn corners(&self) -> usize {
        0
    }

    /// The magnitude of the terms of corner number `index`, if it is a guard now: positive while the field is what it is.
    ///
    /// Its fall ends that. It is watched inside steps too, and from their very beginning; only there steps end, and the
    /// integrator tells which guard fell.
    fn guard(&self, _index: usize) -> Option<f64> {
        None
    }

    /// What kink function number `index` is small against, if it is `from` and `to` at the ends of a step.
    fn kink_size(&self, _index: usize, _from: f64, _to: f64) -> f64 {
        1.0
    }

    /// A function of the state that changes sign on kink surface number `index`.
    fn kink(&self, _index: usize, _y: &[f64; N]) -> f64 {
        1.0
    }
}
