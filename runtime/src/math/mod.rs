//! The functions that formulas may use, over any [`Scalar`].

mod difference;
pub mod enclosure;
mod extrapolation;
pub mod interval;
#[doc(hidden)]
pub mod slope;
mod spread;

pub(crate) use difference::ends;
pub(crate) use extrapolation::{at_zero, line};
pub(crate) use spread::Spread;

use crate::scalar::Scalar;

macro_rules! functions {
    ($($name:ident: $doc:literal;)*) => {$(
        #[doc = $doc]
        #[inline]
        pub fn $name<D: Scalar>(x: D) -> D {
            x.$name()
        }
    )*};
}

functions! {
    acos: "The angle whose cosine is `x`.";
    acosh: "Inverse hyperbolic cosine.";
    asin: "The angle whose sine is `x`.";
    asinh: "Inverse hyperbolic sine.";
    atan: "The angle whose tangent is `x`.";
    atanh: "Inverse hyperbolic tangent.";
    cos: "Cosine.";
    cosh: "Hyperbolic cosine.";
    exp: "eˣ.";
    ln: "Natural logarithm.";
    sin: "Sine.";
    sinh: "Hyperbolic sine.";
    sqrt: "Square root.";
    tan: "Tangent.";
}

/// Magnitude; on its kink, that of the side from which 0 or −0 comes.
#[inline]
pub fn abs<D: Scalar>(x: D) -> D {
    if x.re().is_sign_negative() { -x } else { x }
}

/// 1 or −1; only where it multiplies something that vanishes with `x` is the product continuous.
#[inline]
pub fn sign<D: Scalar>(x: D) -> D {
    D::from(1.0_f64.copysign(x.re()))
}

/// Hyperbolic tangent; ±1 where it rounds to that, so that no derivative overflows.
#[inline]
pub fn tanh<D: Scalar>(x: D) -> D {
    if x.re().abs() > 22.0 {
        return D::from(x.re().signum());
    }
    x.tanh()
}

/// `x` to the whole power `n`, by products; a negative power is the reciprocal of the positive one.
#[inline]
pub fn powi<D: Scalar>(x: D, n: i32) -> D {
    let mut power = D::from(1.0);
    for _ in 0..n.unsigned_abs() {
        power *= x;
    }
    if n < 0 { power.recip() } else { power }
}

/// `x` to any real power that is itself a formula: exp(p ln x), for x > 0; 0 at x = 0 when p > 0.
#[inline]
pub fn powf<D: Scalar>(x: D, p: D) -> D {
    if x.re() == 0.0 && p.re() > 0.0 {
        return if p.re() == 1.0 { x } else { D::from(0.0) };
    }
    (p * x.ln()).exp()
}

/// `x` to a fixed real power: unlike [`powf`], accurate to rounding; 0 at x = 0 when p > 1.
#[inline]
pub fn power<D: Scalar>(x: D, p: f64) -> D {
    if x.re() == 0.0 && p > 1.0 {
        return D::from(0.0);
    }
    x.powf(p)
}
