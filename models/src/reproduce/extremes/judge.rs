//! How far two answers, or an answer and a limit, are apart.

use stickslip::study::OrbitRecord;

/// Largest relative difference of period and extrema.
pub(super) fn difference(a: &OrbitRecord, b: &OrbitRecord) -> f64 {
    let extrema = |of: fn(&OrbitRecord) -> &Vec<f64>| {
        let pairs = of(a).iter().zip(of(b)).zip(&b.max_abs);
        pairs.map(|((x, y), size)| (x - y).abs() / size.max(f64::MIN_POSITIVE))
    };
    extrema(|orbit| &orbit.max)
        .chain(extrema(|orbit| &orbit.min))
        .fold((a.period / b.period - 1.0).abs(), f64::max)
}

/// What is known of an orbit without computing it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Limit {
    /// Which quantity.
    pub(super) of: Quantity,
    /// Its value there.
    pub(super) value: f64,
    /// How far from it the true value may be, relative to it.
    pub(super) remainder: f64,
}

/// A quantity of an orbit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Quantity {
    /// Its period.
    Period,
    /// The largest value of its first state.
    Max,
    /// The largest magnitude of its first state.
    Amplitude,
}

impl Limit {
    /// A period known but for this relative remainder.
    pub(super) fn period(value: f64, remainder: f64) -> Self {
        let of = Quantity::Period;
        Self {
            of,
            value,
            remainder,
        }
    }

    /// A largest value known but for this relative remainder.
    pub(super) fn max(value: f64, remainder: f64) -> Self {
        let of = Quantity::Max;
        Self {
            of,
            value,
            remainder,
        }
    }

    /// An amplitude known but for this relative remainder.
    pub(super) fn amplitude(value: f64, remainder: f64) -> Self {
        let of = Quantity::Amplitude;
        Self {
            of,
            value,
            remainder,
        }
    }

    /// By how much more than the remainder an orbit is off; nothing if it is not.
    pub(super) fn error(&self, orbit: &OrbitRecord) -> f64 {
        let found = match self.of {
            Quantity::Period => orbit.period,
            Quantity::Max => orbit.max.first().copied().unwrap_or(f64::NAN),
            Quantity::Amplitude => orbit.max_abs.first().copied().unwrap_or(f64::NAN),
        };
        let off = (found / self.value - 1.0).abs() - self.remainder;
        if off.is_nan() { 1.0 } else { off.max(0.0) }
    }
}
