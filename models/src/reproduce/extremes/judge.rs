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
#[derive(Debug, Clone, Copy)]
pub(super) struct Limit {
    /// Which quantity.
    pub(super) of: fn(&OrbitRecord) -> f64,
    /// Its value there.
    pub(super) value: f64,
    /// How far from it the true value may be, relative to it.
    pub(super) remainder: f64,
}

impl Limit {
    /// A period known but for this relative remainder.
    pub(super) const fn period(value: f64, remainder: f64) -> Self {
        let of = |orbit: &OrbitRecord| orbit.period;
        Self {
            of,
            value,
            remainder,
        }
    }

    /// A largest value of the first state known but for this relative remainder.
    pub(super) const fn max(value: f64, remainder: f64) -> Self {
        let of = |orbit: &OrbitRecord| orbit.max.first().copied().unwrap_or(f64::NAN);
        Self {
            of,
            value,
            remainder,
        }
    }

    /// A largest magnitude of the first state known but for this relative remainder.
    pub(super) const fn amplitude(value: f64, remainder: f64) -> Self {
        let of = |orbit: &OrbitRecord| orbit.max_abs.first().copied().unwrap_or(f64::NAN);
        Self {
            of,
            value,
            remainder,
        }
    }

    /// By how much more than the remainder an orbit is off; nothing if it is not.
    pub(super) fn error(&self, orbit: &OrbitRecord) -> f64 {
        let off = ((self.of)(orbit) / self.value - 1.0).abs() - self.remainder;
        if off.is_nan() { 1.0 } else { off.max(0.0) }
    }
}
