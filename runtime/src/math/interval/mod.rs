//! Intervals of real numbers, rounded outwards: what is computed with them encloses what is true.
//!
//! Sums, products, quotients and square roots are correctly rounded by IEEE 754, so that the next number outwards
//! bounds them. The functions of the mathematical library are not: their values are widened by 16 units in the last
//! place, several times what the common libraries are measured to be off. This is the one assumption behind a proof.

mod functions;

use std::ops::{Add, Div, Mul, Neg, Sub};

/// The real numbers from one end to the other, both included; an end may be infinite.
///
/// ```
/// use stickslip::math::interval::Interval;
/// let tenth = Interval::from(1.0) / Interval::from(10.0);
/// assert!(tenth.low() < tenth.high() && tenth.contains(0.1));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    low: f64,
    high: f64,
}

impl Interval {
    /// Every real number: nothing is known.
    pub const ENTIRE: Self = Self {
        low: f64::NEG_INFINITY,
        high: f64::INFINITY,
    };
    /// Nothing but 0.
    pub const ZERO: Self = Self {
        low: 0.0,
        high: 0.0,
    };
    /// Nothing but 1.
    pub const ONE: Self = Self {
        low: 1.0,
        high: 1.0,
    };

    /// From `low` to `high`; every real number if that is no interval.
    #[must_use]
    pub fn new(low: f64, high: f64) -> Self {
        if low <= high && low < f64::INFINITY && high > f64::NEG_INFINITY {
            Self { low, high }
        } else {
            Self::ENTIRE
        }
    }

    /// All numbers that are not further than `radius` from `centre`.
    #[must_use]
    pub fn around(centre: f64, radius: f64) -> Self {
        Self::outwards(centre - radius.abs(), centre + radius.abs())
    }

    /// Between numbers that are off by rounding to the nearest.
    fn outwards(low: f64, high: f64) -> Self {
        Self::new(low.next_down(), high.next_up())
    }

    /// The lower end.
    #[must_use]
    pub fn low(self) -> f64 {
        self.low
    }

    /// The upper end.
    #[must_use]
    pub fn high(self) -> f64 {
        self.high
    }

    /// A number in the middle; 0 if nothing is known.
    #[must_use]
    pub fn middle(self) -> f64 {
        let middle = 0.5 * self.low + 0.5 * self.high;
        if middle.is_finite() { middle } else { 0.0 }
    }

    /// The largest magnitude.
    #[must_use]
    pub fn magnitude(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// Whether a number lies in it.
    #[must_use]
    pub fn contains(self, value: f64) -> bool {
        self.low <= value && value <= self.high
    }

    /// Whether it lies within `other` and touches neither of its ends.
    #[must_use]
    pub fn is_inside(self, other: Self) -> bool {
        other.low < self.low && self.high < other.high
    }

    /// What lies in either, and between them.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Self::new(self.low.min(other.low), self.high.max(other.high))
    }

    /// Each number x as the nearest one to it between `low` and `high`.
    #[must_use]
    pub fn clamped(self, low: f64, high: f64) -> Self {
        Self::new(self.low.clamp(low, high), self.high.clamp(low, high))
    }

    fn is_point(self, value: f64) -> bool {
        self.low == value && self.high == value
    }

    /// From the least to the largest of four numbers that are off by rounding.
    fn spanned(ends: [f64; 4]) -> Self {
        if ends.iter().any(|end| end.is_nan()) {
            return Self::ENTIRE;
        }
        let low = ends.into_iter().fold(f64::INFINITY, f64::min);
        let high = ends.into_iter().fold(f64::NEG_INFINITY, f64::max);
        Self::outwards(low, high)
    }
}

/// A number itself; one that is none says nothing.
impl From<f64> for Interval {
    fn from(value: f64) -> Self {
        Self::new(value, value)
    }
}

impl Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            low: -self.high,
            high: -self.low,
        }
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        if self.is_point(0.0) {
            return other;
        }
        if other.is_point(0.0) {
            return self;
        }
        Self::outwards(self.low + other.low, self.high + other.high)
    }
}

impl Sub for Interval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        if self.is_point(1.0) || other.is_point(0.0) {
            return other;
        }
        if other.is_point(1.0) || self.is_point(0.0) {
            return self;
        }
        // Zero times any real number is zero, however large the number may be.
        let times = |a: f64, b: f64| if a == 0.0 || b == 0.0 { 0.0 } else { a * b };
        Self::spanned([
            times(self.low, other.low),
            times(self.low, other.high),
            times(self.high, other.low),
            times(self.high, other.high),
        ])
    }
}

impl Div for Interval {
    type Output = Self;

    /// Nothing is known of a quotient whose divisor may vanish.
    fn div(self, other: Self) -> Self {
        if other.contains(0.0) {
            return Self::ENTIRE;
        }
        if self.is_point(0.0) || other.is_point(1.0) {
            return self;
        }
        Self::spanned([
            self.low / other.low,
            self.low / other.high,
            self.high / other.low,
            self.high / other.high,
        ])
    }
}

#[cfg(test)]
mod tests;
