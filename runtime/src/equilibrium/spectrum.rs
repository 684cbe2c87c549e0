//! Eigenvalues of an equilibrium, and what they say.

use nalgebra::{Complex, DMatrix};

use crate::bifurcation::{Growth, Growths, Stability};
use crate::linear::{Eigenvalue, eigenvalues};

/// The eigenvalues of a Jacobian.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// Largest real part first; one that is zero as far as rounding tells is zero. Empty if the Jacobian is not finite.
    pub eigenvalues: Vec<Complex<f64>>,
    /// The same with their errors, in the same order.
    pub growths: Growths,
    /// How many have a positive real part, beyond rounding.
    pub unstable: usize,
    /// What they say together.
    pub stability: Stability,
}

impl Spectrum {
    /// Of an n × n Jacobian.
    #[must_use]
    pub fn of(jacobian: &DMatrix<f64>) -> Self {
        Self::judged(&eigenvalues(jacobian), jacobian.nrows())
    }

    /// The same without the `neutral` eigenvalues that are zero because an equilibrium belongs to a set, and
    /// because contacts stick.
    #[must_use]
    pub fn across(jacobian: &DMatrix<f64>, neutral: usize) -> Self {
        let mut all = eigenvalues(jacobian);
        all.sort_by(|a, b| b.value.norm().total_cmp(&a.value.norm()));
        let others = jacobian.nrows().saturating_sub(neutral);
        all.truncate(others);
        Self::judged(&all, others)
    }

    fn judged(all: &[Eigenvalue], count: usize) -> Self {
        let growth = |one: &Eigenvalue| Growth::new(one.value, one.error(f64::EPSILON));
        let growths = Growths::new(all.iter().map(growth).collect());
        let value = |one: &Growth| {
            let re = if one.is_marginal() { 0.0 } else { one.rate };
            Complex::new(re, one.turn)
        };
        Self {
            eigenvalues: growths.iter().map(value).collect(),
            unstable: growths.growing(),
            stability: match all.len() == count {
                true => growths.stability(),
                false => Stability::Undecided,
            },
            growths,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_centre_is_undecided_in_any_units() {
        for (unit, stiffness) in [(1.0, 1.0), (1e6, 1.0), (1e-5, 3e12)] {
            let rows = [0.0, unit, -stiffness / unit, 0.0];
            let centre = Spectrum::of(&DMatrix::from_row_slice(2, 2, &rows));
            assert_eq!(centre.stability, Stability::Undecided);
            assert_eq!((centre.unstable, centre.growths.marginal()), (0, 2));
            assert_eq!(centre.eigenvalues[0].re, 0.0);
        }
    }

    #[test]
    fn weak_damping_is_seen_in_any_units() {
        for (unit, stiffness) in [(1.0, 1.0), (1e6, 1.0), (1e-5, 3e12)] {
            let damping = 1e-8 * f64::sqrt(stiffness);
            let rows = [0.0, unit, -stiffness / unit, -damping];
            let centre = Spectrum::of(&DMatrix::from_row_slice(2, 2, &rows));
            assert_eq!(centre.stability, Stability::Stable, "{unit}");
        }
    }
}
