//! Functions of intervals: from their values at the ends, and from where they turn.

use std::f64::consts::{FRAC_PI_2, PI};

use super::Interval;

/// Units in the last place by which the mathematical library may be off.
const LIBRARY: f64 = 16.0;
/// How near to a turning point, in half periods, an end counts as beyond it.
const TURN: f64 = 1e-12;
/// Arguments beyond which a period is no longer resolved well enough to say where a function turns.
const FAR: f64 = 1e6;

/// The largest error of a function of the library whose value is this.
fn slack(value: f64) -> f64 {
    LIBRARY * (f64::EPSILON * value.abs() + f64::from_bits(1))
}

impl Interval {
    /// From a value of the library at the lower end to one at the upper end.
    fn library(low: f64, high: f64) -> Self {
        Self::outwards(low - slack(low), high + slack(high))
    }

    fn rising(self, function: impl Fn(f64) -> f64) -> Self {
        Self::library(function(self.low), function(self.high))
    }

    /// |x|.
    #[must_use]
    pub fn abs(self) -> Self {
        if self.low >= 0.0 {
            self
        } else if self.high <= 0.0 {
            -self
        } else {
            Self::new(0.0, self.magnitude())
        }
    }

    /// √x; nothing is known where some x is negative.
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.low < 0.0 {
            return Self::ENTIRE;
        }
        let root = Self::outwards(self.low.sqrt(), self.high.sqrt());
        root.clamped(0.0, f64::INFINITY)
    }

    /// The cube root.
    #[must_use]
    pub fn cbrt(self) -> Self {
        self.rising(f64::cbrt)
    }

    /// eˣ.
    #[must_use]
    pub fn exp(self) -> Self {
        self.rising(f64::exp).clamped(0.0, f64::INFINITY)
    }

    /// eˣ − 1.
    #[must_use]
    pub fn exp_m1(self) -> Self {
        self.rising(f64::exp_m1).clamped(-1.0, f64::INFINITY)
    }

    /// ln x; nothing is known where some x is not positive.
    #[must_use]
    pub fn ln(self) -> Self {
        if self.low <= 0.0 {
            return Self::ENTIRE;
        }
        self.rising(f64::ln)
    }

    /// ln(1 + x); nothing is known where some x is not above −1.
    #[must_use]
    pub fn ln_1p(self) -> Self {
        if self.low <= -1.0 {
            return Self::ENTIRE;
        }
        self.rising(f64::ln_1p)
    }

    /// x to a fixed power; nothing is known where some x is not positive.
    #[must_use]
    pub fn powf(self, power: f64) -> Self {
        if self.low <= 0.0 {
            return Self::ENTIRE;
        }
        let ends = [self.low.powf(power), self.high.powf(power)];
        let positive = Self::library(ends[0].min(ends[1]), ends[0].max(ends[1]));
        positive.clamped(0.0, f64::INFINITY)
    }

    /// x to a whole power, which rises with x or with |x|.
    #[must_use]
    pub fn powi(self, power: i32) -> Self {
        let size = power.unsigned_abs();
        let base = if size.is_multiple_of(2) {
            self.abs()
        } else {
            self
        };
        let end = |x: f64| (0..size).fold(Self::ONE, |product, _| product * Self::from(x));
        let raised = end(base.low).hull(end(base.high));
        if power < 0 {
            Self::ONE / raised
        } else {
            raised
        }
    }

    /// Sine.
    #[must_use]
    pub fn sin(self) -> Self {
        self.turning(f64::sin, 0.5)
    }

    /// Cosine.
    #[must_use]
    pub fn cos(self) -> Self {
        self.turning(f64::cos, 0.0)
    }

    /// A function that turns at (k + `first`) π: to 1 for an even k, to −1 for an odd one.
    fn turning(self, function: impl Fn(f64) -> f64, first: f64) -> Self {
        if self.magnitude() > FAR {
            return Self::new(-1.0, 1.0);
        }
        let (from, to) = self.half_turns(first);
        let turns = from.ceil()..=to.floor();
        let odd = |k: f64| k.rem_euclid(2.0) == 1.0;
        let next = turns.start() + 1.0;
        let both = turns.contains(&next);
        let first = turns.contains(turns.start()).then_some(*turns.start());
        let (up, down) = (
            both || first.is_some_and(|k| !odd(k)),
            both || first.is_some_and(odd),
        );
        let ends = [function(self.low), function(self.high)];
        let plain = Self::library(ends[0].min(ends[1]), ends[0].max(ends[1]));
        let low = if down { -1.0 } else { plain.low.max(-1.0) };
        let high = if up { 1.0 } else { plain.high.min(1.0) };
        Self::new(low, high)
    }

    /// Both ends in half turns after the turn `first`, a little further outwards.
    fn half_turns(self, first: f64) -> (f64, f64) {
        let turns = |x: f64| x / PI - first;
        let margin = TURN * (1.0 + self.magnitude());
        (turns(self.low) - margin, turns(self.high) + margin)
    }

    /// Tangent; nothing is known across one of its poles.
    #[must_use]
    pub fn tan(self) -> Self {
        let (from, to) = self.half_turns(0.5);
        if self.magnitude() > FAR || from.ceil() <= to {
            return Self::ENTIRE;
        }
        self.rising(f64::tan)
    }

    /// The angle between −π/2 and π/2 whose tangent is x.
    #[must_use]
    pub fn atan(self) -> Self {
        self.rising(f64::atan)
    }

    /// The angle whose sine is x; nothing is known where some x is beyond ±1.
    #[must_use]
    pub fn asin(self) -> Self {
        if self.low < -1.0 || self.high > 1.0 {
            return Self::ENTIRE;
        }
        self.rising(f64::asin)
    }

    /// The angle whose cosine is x; nothing is known where some x is beyond ±1.
    #[must_use]
    pub fn acos(self) -> Self {
        if self.low < -1.0 || self.high > 1.0 {
            return Self::ENTIRE;
        }
        // π/2 itself lies within one unit of its number.
        Self::around(FRAC_PI_2, f64::EPSILON) - self.asin()
    }

    /// Hyperbolic sine.
    #[must_use]
    pub fn sinh(self) -> Self {
        self.rising(f64::sinh)
    }

    /// Hyperbolic cosine.
    #[must_use]
    pub fn cosh(self) -> Self {
        self.abs().rising(f64::cosh).clamped(1.0, f64::INFINITY)
    }

    /// Hyperbolic tangent.
    #[must_use]
    pub fn tanh(self) -> Self {
        self.rising(f64::tanh).clamped(-1.0, 1.0)
    }

    /// Inverse hyperbolic sine: each end by ln(|x| + √(x² + 1)).
    #[must_use]
    pub fn asinh(self) -> Self {
        let end = |x: f64| {
            let size = Self::from(x.abs());
            let value = (size + (size * size + Self::ONE).sqrt()).ln();
            if x < 0.0 { -value } else { value }
        };
        end(self.low).hull(end(self.high))
    }

    /// Inverse hyperbolic cosine, ln(x + √((x − 1)(x + 1))); nothing is known where some x is below 1.
    #[must_use]
    pub fn acosh(self) -> Self {
        let end = |x: f64| {
            let x = Self::from(x);
            (x + ((x - Self::ONE) * (x + Self::ONE))
                .clamped(0.0, f64::INFINITY)
                .sqrt())
            .ln()
        };
        if self.low < 1.0 {
            return Self::ENTIRE;
        }
        end(self.low).hull(end(self.high))
    }

    /// Inverse hyperbolic tangent, ln((1 + x) / (1 − x)) / 2; nothing is known where some |x| reaches 1.
    #[must_use]
    pub fn atanh(self) -> Self {
        let end = |x: f64| {
            let x = Self::from(x);
            ((Self::ONE + x) / (Self::ONE - x)).ln() * Self::from(0.5)
        };
        if self.magnitude() >= 1.0 {
            return Self::ENTIRE;
        }
        end(self.low).hull(end(self.high))
    }
}
