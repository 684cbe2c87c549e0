//! Enclosures as numbers: arithmetic by the rules for derivatives, functions by the chain rule.

use std::cmp::Ordering;
use std::fmt;
use std::iter::{Product, Sum};
use std::ops::{
    Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign,
};

use num_dual::{DualNum, DualStruct, Mappable};
use num_traits::{FromPrimitive, Inv, Num, One, Signed, Zero};

use super::Enclosure;
use crate::math::interval::Interval;

const UNKNOWN: Interval = Interval::ENTIRE;

impl<const N: usize> Enclosure<N> {
    fn combined(self, other: Self, value: Interval, [a, b]: [Interval; 2]) -> Self {
        Self {
            value,
            slopes: std::array::from_fn(|j| self.slopes[j] * a + other.slopes[j] * b),
        }
    }

    fn sum(self, other: Self) -> Self {
        self.combined(other, self.value + other.value, [Interval::ONE; 2])
    }

    fn difference(self, other: Self) -> Self {
        let by = [Interval::ONE, -Interval::ONE];
        self.combined(other, self.value - other.value, by)
    }

    fn product(self, other: Self) -> Self {
        let by = [other.value, self.value];
        self.combined(other, self.value * other.value, by)
    }

    fn quotient(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        let by = [Interval::ONE / other.value, -quotient / other.value];
        self.combined(other, quotient, by)
    }

    /// Nothing is known of a remainder: no formula has one.
    fn remainder(self, _: Self) -> Self {
        self.unknown()
    }

    fn unknown(&self) -> Self {
        self.chained(UNKNOWN, UNKNOWN)
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident $assign:ident $assigned:ident = $rule:ident;)*) => {$(
        impl<const N: usize> $operator for Enclosure<N> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                self.$rule(other)
            }
        }

        impl<const N: usize> $operator<&Self> for Enclosure<N> {
            type Output = Self;
            fn $method(self, other: &Self) -> Self {
                self.$rule(*other)
            }
        }

        impl<const N: usize> $operator<f64> for Enclosure<N> {
            type Output = Self;
            fn $method(self, other: f64) -> Self {
                self.$rule(Self::from(other))
            }
        }

        impl<const N: usize> $assign for Enclosure<N> {
            fn $assigned(&mut self, other: Self) {
                *self = self.$rule(other);
            }
        }

        impl<const N: usize> $assign<f64> for Enclosure<N> {
            fn $assigned(&mut self, other: f64) {
                *self = self.$rule(Self::from(other));
            }
        }
    )*};
}

operators! {
    Add add AddAssign add_assign = sum;
    Sub sub SubAssign sub_assign = difference;
    Mul mul MulAssign mul_assign = product;
    Div div DivAssign div_assign = quotient;
    Rem rem RemAssign rem_assign = remainder;
}

impl<const N: usize> Neg for Enclosure<N> {
    type Output = Self;

    fn neg(self) -> Self {
        self.chained(-self.value, -Interval::ONE)
    }
}

impl<const N: usize> From<f64> for Enclosure<N> {
    fn from(value: f64) -> Self {
        Self::constant(Interval::from(value))
    }
}

impl<const N: usize> Sum for Enclosure<N> {
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        terms.fold(Self::zero(), |sum, term| sum + term)
    }
}

impl<const N: usize> Product for Enclosure<N> {
    fn product<I: Iterator<Item = Self>>(factors: I) -> Self {
        factors.fold(Self::one(), |product, factor| product * factor)
    }
}

impl<const N: usize> Zero for Enclosure<N> {
    fn zero() -> Self {
        Self::from(0.0)
    }

    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl<const N: usize> One for Enclosure<N> {
    fn one() -> Self {
        Self::from(1.0)
    }
}

impl<const N: usize> Num for Enclosure<N> {
    type FromStrRadixErr = num_traits::ParseFloatError;

    fn from_str_radix(text: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
        f64::from_str_radix(text, radix).map(Self::from)
    }
}

/// Only what holds for every value is told.
impl<const N: usize> Signed for Enclosure<N> {
    fn abs(&self) -> Self {
        self.magnitude()
    }

    fn abs_sub(&self, other: &Self) -> Self {
        (*self - other).clamped(0.0, f64::INFINITY)
    }

    fn signum(&self) -> Self {
        match self.magnitude() {
            same if same == *self => Self::one(),
            other if other == -*self => -Self::one(),
            _ => self.chained(Interval::new(-1.0, 1.0), UNKNOWN),
        }
    }

    fn is_positive(&self) -> bool {
        self.value.low() > 0.0
    }

    fn is_negative(&self) -> bool {
        self.value.high() < 0.0
    }
}

impl<const N: usize> Inv for Enclosure<N> {
    type Output = Self;

    fn inv(self) -> Self {
        Self::one() / self
    }
}

impl<const N: usize> FromPrimitive for Enclosure<N> {
    fn from_i64(value: i64) -> Option<Self> {
        f64::from_i64(value).map(Self::from)
    }

    fn from_u64(value: u64) -> Option<Self> {
        f64::from_u64(value).map(Self::from)
    }

    fn from_f64(value: f64) -> Option<Self> {
        Some(Self::from(value))
    }
}

/// Two enclosures are ordered where all their values are.
impl<const N: usize> PartialOrd for Enclosure<N> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        if self == other {
            Some(Ordering::Equal)
        } else if self.value.high() < other.value.low() {
            Some(Ordering::Less)
        } else if self.value.low() > other.value.high() {
            Some(Ordering::Greater)
        } else {
            None
        }
    }
}

impl<const N: usize> PartialEq<f64> for Enclosure<N> {
    fn eq(&self, other: &f64) -> bool {
        self.value == Interval::from(*other)
    }
}

impl<const N: usize> PartialOrd<f64> for Enclosure<N> {
    fn partial_cmp(&self, other: &f64) -> Option<Ordering> {
        let other = Self::constant(Interval::from(*other));
        Self::constant(self.value).partial_cmp(&other)
    }
}

impl<const N: usize> fmt::Display for Enclosure<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "[{}, {}]", self.value.low(), self.value.high())
    }
}

impl<const N: usize> DualStruct for Enclosure<N> {
    type Real = f64;
    type Inner = Self;

    /// NaN, with the sign of the values where they have one.
    fn re(&self) -> f64 {
        f64::NAN.copysign(if self.is_negative() { -1.0 } else { 1.0 })
    }

    fn from_inner(inner: &Self) -> Self {
        *inner
    }
}

impl<const N: usize> Mappable<Self> for Enclosure<N> {
    type Output<O> = O;

    fn map_dual<M: Fn(Self) -> O, O>(self, map: M) -> O {
        map(self)
    }
}

/// 1 / √x.
fn inverse_root(x: Interval) -> Interval {
    Interval::ONE / x.sqrt()
}

/// 1 − x².
fn complement(x: Interval) -> Interval {
    (Interval::ONE - x) * (Interval::ONE + x)
}

/// x² + 1, or x² − 1.
fn square_and(x: Interval, one: Interval) -> Interval {
    x.powi(2) + one
}

macro_rules! functions {
    ($($name:ident($x:ident, $value:ident) = $slope:expr;)*) => {$(
        fn $name(&self) -> Self {
            let $x = self.value;
            let $value = $x.$name();
            let slope = { let _ = $value; $slope };
            self.chained($value, slope)
        }
    )*};
}

impl<const N: usize> DualNum for Enclosure<N> {
    type Primitive = f64;
    const NDERIV: usize = 1;
    type InnerDual = Self;

    functions! {
        sqrt(x, value) = Interval::ONE / (value + value);
        cbrt(x, value) = Interval::ONE / (Interval::from(3.0) * value.powi(2));
        exp(x, value) = value;
        exp_m1(x, value) = x.exp();
        ln(x, value) = Interval::ONE / x;
        ln_1p(x, value) = Interval::ONE / (Interval::ONE + x);
        sin(x, value) = x.cos();
        cos(x, value) = -x.sin();
        tan(x, value) = square_and(value, Interval::ONE);
        atan(x, value) = Interval::ONE / square_and(x, Interval::ONE);
        asin(x, value) = inverse_root(complement(x));
        acos(x, value) = -inverse_root(complement(x));
        sinh(x, value) = x.cosh();
        cosh(x, value) = x.sinh();
        tanh(x, value) = complement(value).clamped(0.0, 1.0);
        asinh(x, value) = inverse_root(square_and(x, Interval::ONE));
        acosh(x, value) = inverse_root(square_and(x, -Interval::ONE));
        atanh(x, value) = Interval::ONE / complement(x);
    }

    fn from_re(re: Self) -> Self {
        re
    }

    fn scale(self, factor: &Self) -> Self {
        self * factor
    }

    fn recip(&self) -> Self {
        self.inv()
    }

    fn powi(&self, n: i32) -> Self {
        let slope = match n.checked_sub(1) {
            Some(less) => Interval::from(f64::from(n)) * self.value.powi(less),
            None => UNKNOWN,
        };
        self.chained(self.value.powi(n), slope)
    }

    fn powf(&self, n: f64) -> Self {
        let value = self.value.powf(n);
        self.chained(value, Interval::from(n) * value / self.value)
    }

    fn exp2(&self) -> Self {
        (*self * Self::from(2.0).ln()).exp()
    }

    fn log(&self, base: f64) -> Self {
        self.ln() / Self::from(base).ln()
    }

    fn log2(&self) -> Self {
        self.log(2.0)
    }

    fn log10(&self) -> Self {
        self.log(10.0)
    }

    fn sin_cos(&self) -> (Self, Self) {
        (self.sin(), self.cos())
    }

    /// Nothing is known of it: no formula has it.
    fn atan2(&self, _: Self) -> Self {
        self.unknown()
    }

    /// Nothing is known of it: no formula has it.
    fn sph_j0(&self) -> Self {
        self.unknown()
    }

    /// Nothing is known of it: no formula has it.
    fn sph_j1(&self) -> Self {
        self.unknown()
    }

    /// Nothing is known of it: no formula has it.
    fn sph_j2(&self) -> Self {
        self.unknown()
    }
}
