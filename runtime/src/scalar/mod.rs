//! Numbers that a model can be evaluated with: plain, or carrying derivatives.

pub(crate) mod number;
mod wide;

use nalgebra::SVector;
use num_dual::{Derivative, DualNum, DualSVec64};

pub use wide::Wide;

/// A number that a declared formula can be evaluated with: `f64`, or a dual number over it.
///
/// Implemented for every type that qualifies; nobody needs to implement it by hand.
///
/// ```
/// use stickslip::scalar::Scalar;
/// fn cube<D: Scalar>(x: D) -> D { x * x * x }
/// assert_eq!(cube(2.0), 8.0);
/// let dual = cube(num_dual::Dual64::new(2.0, 1.0));
/// assert_eq!(dual.eps, 12.0); // 3 x²
/// ```
pub trait Scalar: DualNum<Primitive = f64> + Copy + Send + Sync {}

impl<D: DualNum<Primitive = f64> + Copy + Send + Sync> Scalar for D {}

/// A dual number with one lane for each of `N` states and a last one for the design variable.
///
/// One evaluation of a right-hand side over such numbers gives f, its Jacobian and ∂f/∂r.
pub trait Lanes<const N: usize>: Scalar {
    /// A constant: every lane zero.
    fn constant(value: f64) -> Self;
    /// The state of this index: its own lane one.
    fn state(value: f64, index: usize) -> Self;
    /// A quantity whose derivative with respect to the design variable is `slope`.
    fn design(value: f64, slope: f64) -> Self;
    /// The derivative with respect to each state, and to the design variable.
    fn slopes(&self) -> ([f64; N], f64);
}

impl<const N: usize, const P: usize> Lanes<N> for DualSVec64<P> {
    #[inline]
    fn constant(value: f64) -> Self {
        Self::from_re(value)
    }

    #[inline]
    fn state(value: f64, index: usize) -> Self {
        const {
            assert!(
                P == N + 1,
                "one lane for each state and one for the design variable"
            )
        };
        Self::from_re(value).derivative(index)
    }

    #[inline]
    fn design(value: f64, slope: f64) -> Self {
        let mut lanes = SVector::zeros();
        lanes[N] = slope;
        Self::new(value, Derivative::some(lanes))
    }

    #[inline]
    fn slopes(&self) -> ([f64; N], f64) {
        match self.eps.0 {
            Some(lanes) => (filled(|i| lanes[i]), lanes[N]),
            None => ([0.0; N], 0.0),
        }
    }
}

/// An array whose length only its owner knows: parameters of a model, values for each contact.
pub trait Inline<T>: Copy + AsRef<[T]> + AsMut<[T]> + Send + Sync {
    /// Fills the array from the function of the index.
    fn from_fn(element: impl FnMut(usize) -> T) -> Self;
}

impl<T: Copy + Send + Sync, const LENGTH: usize> Inline<T> for [T; LENGTH] {
    #[inline]
    fn from_fn(element: impl FnMut(usize) -> T) -> Self {
        filled(element)
    }
}

/// An array filled from the function of the index. The standard library's `from_fn`, which may stop half way, is four functions
/// for each function that it calls; without it an eighth less is to compile of every model.
#[inline]
pub(crate) fn filled<T: Copy, const LENGTH: usize>(
    mut element: impl FnMut(usize) -> T,
) -> [T; LENGTH] {
    if const { LENGTH == 0 } {
        return empty();
    }
    let mut all = [element(0); LENGTH];
    let mut i = 1;
    while i < LENGTH {
        all[i] = element(i);
        i += 1;
    }
    all
}

/// An array without elements.
fn empty<T: Copy, const LENGTH: usize>() -> [T; LENGTH] {
    let Ok(empty) = <[T; LENGTH]>::try_from(&[] as &[T]) else {
        unreachable!("an empty array has no element")
    };
    empty
}

/// The product of two vectors.
#[inline]
pub(crate) fn dot<const LENGTH: usize>(a: &[f64; LENGTH], b: &[f64; LENGTH]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// What a function makes of each element of an array: `map` of the standard library is six functions for each that it calls.
#[inline]
pub(crate) fn mapped<T: Copy, U: Copy, const LENGTH: usize>(
    all: &[T; LENGTH],
    mut made: impl FnMut(T) -> U,
) -> [U; LENGTH] {
    filled(|i| made(all[i]))
}
