//! Numbers that enclose: a formula evaluated over a box, with its derivatives there.

mod functions;
mod number;

use super::interval::Interval;

/// All values of a quantity over a box of `N` coordinates, and all values of its derivatives by them.
///
/// It is a [`Scalar`](crate::scalar::Scalar), so that formulas written for numbers can be evaluated over boxes. Its real
/// part is NaN, because a box has no single value: no comparison with it holds, and a formula that branches on it takes
/// the branch that holds in general. Who decides between branches must compare the enclosures themselves. The NaN has
/// the sign of the values, for `math::abs` and `math::sign`: both are right where that sign is strict, and the kinks of a
/// law tell where it is not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Enclosure<const N: usize> {
    /// The values.
    pub value: Interval,
    /// The derivatives by each coordinate; where there is a kink in the box, those of both sides and all between.
    pub slopes: [Interval; N],
}

impl<const N: usize> Enclosure<N> {
    /// A constant.
    #[must_use]
    pub fn constant(value: Interval) -> Self {
        Self {
            value,
            slopes: [Interval::ZERO; N],
        }
    }

    /// The coordinate of this index, over these values.
    #[must_use]
    pub fn coordinate(value: Interval, index: usize) -> Self {
        let mut coordinate = Self::constant(value);
        if let Some(slope) = coordinate.slopes.get_mut(index) {
            *slope = Interval::ONE;
        }
        coordinate
    }

    /// A function of it with these values, whose derivative has these.
    fn chained(&self, value: Interval, slope: Interval) -> Self {
        Self {
            value,
            slopes: self.slopes.map(|own| own * slope),
        }
    }

    /// Each value x as the nearest number to it between `low` and `high`: continuous, with kinks at both.
    #[must_use]
    pub fn clamped(&self, low: f64, high: f64) -> Self {
        let beyond = self.value.high() < low || self.value.low() > high;
        let within = low < self.value.low() && self.value.high() < high;
        let slope = match (beyond, within) {
            (true, _) => Interval::ZERO,
            (_, true) => Interval::ONE,
            _ => Interval::new(0.0, 1.0),
        };
        self.chained(self.value.clamped(low, high), slope)
    }

    /// |x|, with a kink at 0.
    #[must_use]
    pub fn magnitude(&self) -> Self {
        let slope = if self.value.low() > 0.0 {
            Interval::ONE
        } else if self.value.high() < 0.0 {
            -Interval::ONE
        } else {
            Interval::new(-1.0, 1.0)
        };
        self.chained(self.value.abs(), slope)
    }
}

#[cfg(test)]
mod tests;
