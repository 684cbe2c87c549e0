//! Dual numbers with many lanes, whose arithmetic is called and not written out.
//!
//! The formulas of a model with 71 states, over numbers with 72 lanes, are three megabytes of code where each operation is
//! written out for each lane: half of what it takes to compile the model.

use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Rem, Sub};

use num_dual::{DualNum, DualSVec64, DualStruct};
use num_traits::{Inv, Signed};

use super::Lanes;
use super::number::number;

/// A [`DualSVec64`] with the same values, bit for bit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wide<const P: usize>(DualSVec64<P>);

impl<const N: usize, const P: usize> Lanes<N> for Wide<P> {
    fn constant(value: f64) -> Self {
        Self(Lanes::<N>::constant(value))
    }

    fn state(value: f64, index: usize) -> Self {
        Self(Lanes::<N>::state(value, index))
    }

    fn design(value: f64, slope: f64) -> Self {
        Self(Lanes::<N>::design(value, slope))
    }

    fn slopes(&self) -> ([f64; N], f64) {
        Lanes::<N>::slopes(&self.0)
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident;)*) => {$(
        impl<const P: usize> $operator for Wide<P> {
            type Output = Self;
            #[inline(never)]
            fn $method(self, other: Self) -> Self {
                Self($operator::$method(self.0, other.0))
            }
        }

        impl<const P: usize> $operator<f64> for Wide<P> {
            type Output = Self;
            #[inline(never)]
            fn $method(self, other: f64) -> Self {
                Self($operator::$method(self.0, other))
            }
        }
    )*};
}

operators! {
    Add add;
    Sub sub;
    Mul mul;
    Div div;
    Rem rem;
}

number!(Wide);

/// Functions of one number, by what the number inside makes of them.
macro_rules! functions {
    ($($name:ident)*) => {$(
        #[inline(never)]
        fn $name(&self) -> Self {
            Self(self.0.$name())
        }
    )*};
}

impl<const P: usize> DualNum for Wide<P> {
    type Primitive = f64;
    const NDERIV: usize = 1;
    type InnerDual = Self;

    functions! {
        recip sqrt cbrt exp exp2 exp_m1 ln log2 log10 ln_1p sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh
        sph_j0 sph_j1 sph_j2
    }

    fn from_re(re: Self) -> Self {
        re
    }

    fn scale(self, factor: &Self) -> Self {
        self * factor
    }

    #[inline(never)]
    fn powi(&self, n: i32) -> Self {
        Self(self.0.powi(n))
    }

    #[inline(never)]
    fn powf(&self, n: f64) -> Self {
        Self(self.0.powf(n))
    }

    fn log(&self, base: f64) -> Self {
        Self(self.0.log(base))
    }

    fn sin_cos(&self) -> (Self, Self) {
        (self.sin(), self.cos())
    }

    fn atan2(&self, other: Self) -> Self {
        Self(self.0.atan2(other.0))
    }
}

impl<const P: usize> Neg for Wide<P> {
    type Output = Self;

    #[inline(never)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<const P: usize> Inv for Wide<P> {
    type Output = Self;

    fn inv(self) -> Self {
        self.recip()
    }
}

impl<const P: usize> From<f64> for Wide<P> {
    fn from(value: f64) -> Self {
        Self(value.into())
    }
}

impl<const P: usize> Signed for Wide<P> {
    fn abs(&self) -> Self {
        Self(self.0.abs())
    }

    fn abs_sub(&self, other: &Self) -> Self {
        Self(self.0.abs_sub(&other.0))
    }

    fn signum(&self) -> Self {
        Self(self.0.signum())
    }

    fn is_positive(&self) -> bool {
        self.0.is_positive()
    }

    fn is_negative(&self) -> bool {
        self.0.is_negative()
    }
}

impl<const P: usize> PartialOrd for Wide<P> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.0.partial_cmp(&other.0)
    }
}

impl<const P: usize> PartialEq<f64> for Wide<P> {
    fn eq(&self, other: &f64) -> bool {
        self.0 == *other
    }
}

impl<const P: usize> PartialOrd<f64> for Wide<P> {
    fn partial_cmp(&self, other: &f64) -> Option<Ordering> {
        self.0.partial_cmp(other)
    }
}

impl<const P: usize> fmt::Display for Wide<P> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

impl<const P: usize> DualStruct for Wide<P> {
    type Real = f64;
    type Inner = Self;

    fn re(&self) -> f64 {
        DualStruct::re(&self.0)
    }

    fn from_inner(inner: &Self) -> Self {
        *inner
    }
}
