//! Determinants of derivatives: what a motion makes of volumes.

use serde::{Deserialize, Serialize};

/// A determinant by its logarithm, so that neither products nor cancellation lose it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Determinant {
    /// ln |det|; −∞ where it is zero.
    pub log: f64,
    /// Its sign, 1 or −1.
    pub sign: f64,
}

impl Determinant {
    /// That of the identity.
    pub const ONE: Self = Self {
        log: 0.0,
        sign: 1.0,
    };
    /// That of what loses a direction.
    pub const ZERO: Self = Self {
        log: f64::NEG_INFINITY,
        sign: 1.0,
    };

    /// A number.
    #[must_use]
    pub fn of(value: f64) -> Self {
        Self {
            log: value.abs().ln(),
            sign: 1.0_f64.copysign(value),
        }
    }

    /// Liouville's: exp ∫ tr J dt.
    #[must_use]
    pub fn grown(trace: f64) -> Self {
        Self {
            log: trace,
            sign: 1.0,
        }
    }

    /// Whether a direction is lost.
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.log == f64::NEG_INFINITY
    }

    /// That of a product.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        Self {
            log: self.log + other.log,
            sign: self.sign * other.sign,
        }
    }

    /// That of a matrix of moderate condition, by elimination with the largest pivots.
    #[must_use]
    pub fn of_matrix<const N: usize>(mut rows: [[f64; N]; N]) -> Self {
        let mut found = Self::ONE;
        for k in 0..N {
            let size = |i: &usize| rows[*i][k].abs();
            let pivot = (k..N).max_by(|a, b| size(a).total_cmp(&size(b)));
            let pivot = pivot.unwrap_or(k);
            if pivot != k {
                rows.swap(pivot, k);
                found.sign = -found.sign;
            }
            let top = rows[k];
            found = found.times(Self::of(top[k]));
            if top[k] == 0.0 {
                return Self::ZERO;
            }
            for row in &mut rows[k + 1..] {
                let factor = row[k] / top[k];
                for (entry, above) in row.iter_mut().zip(&top).skip(k) {
                    *entry -= factor * above;
                }
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_has_the_determinant_of_its_expansion() {
        let is = |found: Determinant, value: f64| {
            assert_eq!(found.sign, value.signum());
            assert!((found.log - value.abs().ln()).abs() < 1e-15, "{found:?}");
        };
        is(
            Determinant::of_matrix([[0.0, 2.0, 1.0], [1.0, 0.0, 3.0], [4.0, 1.0, 0.0]]),
            25.0,
        );
        is(Determinant::of_matrix([[1.0, 0.0], [3.0, -0.5]]), -0.5);
        assert_eq!(
            Determinant::of_matrix([[1.0, 1.0], [2.0, 2.0]]),
            Determinant::ZERO
        );
    }
}
