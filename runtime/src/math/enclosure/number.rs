//! Enclosures as numbers: arithmetic by the rules for derivatives.

use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Rem, Sub};

use num_dual::DualStruct;
use num_traits::{Inv, One, Signed};

use super::Enclosure;
use crate::math::interval::Interval;
use crate::scalar::number::number;

impl<const N: usize> Enclosure<N> {
    fn combined(self, other: Self, value: Interval, [a, b]: [Interval; 2]) -> Self {
        Self {
            value,
            slopes: crate::scalar::filled(|j| self.slopes[j] * a + other.slopes[j] * b),
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

    /// Nothing is known of what it depends on in some way.
    pub(super) fn unknown(&self) -> Self {
        self.chained(Interval::ENTIRE, Interval::ENTIRE)
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident = $rule:ident;)*) => {$(
        impl<const N: usize> $operator for Enclosure<N> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                self.$rule(other)
            }
        }

        impl<const N: usize> $operator<f64> for Enclosure<N> {
            type Output = Self;
            fn $method(self, other: f64) -> Self {
                self.$rule(Self::from(other))
            }
        }
    )*};
}

operators! {
    Add add = sum;
    Sub sub = difference;
    Mul mul = product;
    Div div = quotient;
    Rem rem = remainder;
}

number!(Enclosure);

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
            _ => self.chained(Interval::new(-1.0, 1.0), Interval::ENTIRE),
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
