//! Scales of axes.

use crate::report::figure::Axis;

/// Free share of an axis beyond data that decide its ends.
const FREE: f64 = 0.04;
/// Ends that differ by less, relative to their size, are one.
const ONE_END: f64 = 1e-12;
/// What is so little outside, in shares of the axis, still is at its end.
const END: f64 = 1e-6;
/// Sizes beyond which distances or their ratios might be infinite.
const LEAST: f64 = 1e-300;
const LARGEST: f64 = 1e300;

/// Where values lie on an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scale {
    /// The values at the ends, or their decadic logarithms.
    pub(super) ends: [f64; 2],
    pub(super) logarithmic: bool,
    counts: bool,
}

impl Scale {
    /// The scale of an axis on which `values` shall be seen.
    pub(super) fn new(axis: &Axis, values: impl Iterator<Item = f64>) -> Self {
        let logarithmic = axis.logarithmic;
        let usable = |value: &f64| value.abs() <= LARGEST && !(logarithmic && *value < LEAST);
        let given = axis.range.filter(|range| range.iter().all(usable));
        let within = |[low, high]: [f64; 2], value: f64| [low.min(value), high.max(value)];
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let [low, high] = match given {
            Some(range) => range.into_iter().fold(nothing, within),
            None => values.filter(usable).fold(nothing, within),
        }
        .map(|end| if logarithmic { end.log10() } else { end });
        let [low, high] = if low > high { [0.0; 2] } else { [low, high] };
        let width = high - low;
        let free = if width > (ONE_END * low.abs().max(high.abs())).max(LEAST) {
            if given.is_some() { 0.0 } else { FREE * width }
        } else if logarithmic || low == 0.0 {
            0.5
        } else {
            0.1 * low.abs()
        };
        Self {
            ends: [low - free, high + free],
            logarithmic,
            counts: axis.counts,
        }
    }

    /// The lowest power of ten of which multiples are marked.
    pub(super) fn finest(&self) -> i32 {
        if self.counts { 0 } else { i32::MIN }
    }

    /// The share of the axis below a value: 0 and 1 at its ends, not finite if it has no place.
    pub(super) fn share(&self, value: f64) -> f64 {
        let [low, high] = self.ends;
        let at = if self.logarithmic {
            value.log10()
        } else {
            value
        };
        (at - low) / (high - low)
    }

    /// How fast the share grows with the value.
    pub(super) fn rate(&self, value: f64) -> f64 {
        let [low, high] = self.ends;
        let stretch = if self.logarithmic {
            value * std::f64::consts::LN_10
        } else {
            1.0
        };
        1.0 / (stretch * (high - low))
    }

    /// Whether a value lies on the axis.
    pub(super) fn holds(&self, value: f64) -> bool {
        (-END..=1.0 + END).contains(&self.share(value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_lie_where_they_should() {
        let axis = || Axis::new("").from(0.01, 100.0);
        let of = |axis: Axis| Scale::new(&axis, std::iter::empty());
        assert!((of(axis()).share(50.005) - 0.5).abs() < 1e-15);
        assert_eq!(of(axis().logarithmic()).share(0.1), 0.25);
        assert!(!of(axis().logarithmic()).share(0.0).is_finite());
    }

    #[test]
    fn any_data_make_a_scale() {
        let of = |values: &[f64]| Scale::new(&Axis::new(""), values.iter().copied()).ends;
        assert_eq!(of(&[]), [-0.5, 0.5]);
        assert_eq!(of(&[f64::NAN, f64::INFINITY, 0.0]), [-0.5, 0.5]);
        assert_eq!(of(&[10.0, 10.0]), [9.0, 11.0]);
        assert_eq!(of(&[0.0, 5e-324]), [-0.5, 0.5]);
        assert_eq!(of(&[0.0, 100.0]), [-4.0, 104.0]);
    }
}
