//! Eigenvalues of an equilibrium, and what they say.

use nalgebra::{Complex, DMatrix};

use crate::bifurcation::{Growth, Growths, Stability};
use crate::linear::{Eigenvalue, eigenvalues};

/// Eigenvalues that differ by no more than this share of the largest on both sides of an equilibrium do so for its curvature.
const CURVED: f64 = 1e-6;

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
        Self::between(jacobian, &[])
    }

    /// The same of an equilibrium on a corner, with these Jacobians on its sides: its rates known to what they differ by.
    #[must_use]
    pub(super) fn between(jacobian: &DMatrix<f64>, sides: &[DMatrix<f64>]) -> Self {
        let sides: Vec<_> = sides.iter().map(eigenvalues).collect();
        Self::judged(&eigenvalues(jacobian), jacobian.nrows(), &sides)
    }

    /// The same without the `neutral` eigenvalues that are zero because an equilibrium belongs to a set, and
    /// because contacts stick.
    #[must_use]
    pub fn across(jacobian: &DMatrix<f64>, neutral: usize) -> Self {
        let mut all = eigenvalues(jacobian);
        all.sort_by(|a, b| b.value.norm().total_cmp(&a.value.norm()));
        let others = jacobian.nrows().saturating_sub(neutral);
        all.truncate(others);
        Self::judged(&all, others, &[])
    }

    fn judged(all: &[Eigenvalue], count: usize, sides: &[Vec<Eigenvalue>]) -> Self {
        let largest = all
            .iter()
            .fold(0.0_f64, |most, one| most.max(one.value.norm()));
        // Rates alone: both halves of a turn may take other times.
        let apart = |one: &Eigenvalue| {
            let off = |other: &Eigenvalue| one.value - other.value;
            let nearest = |side: &Vec<Eigenvalue>| {
                let all = side.iter().map(off);
                all.min_by(|a, b| a.norm().total_cmp(&b.norm()))
            };
            let nearest = sides.iter().filter_map(nearest);
            nearest.fold(0.0_f64, |most, off| most.max(off.re.abs()))
        };
        let growth = |one: &Eigenvalue| {
            let (rounding, apart) = (one.error(f64::EPSILON), apart(one));
            let curved = apart <= CURVED * largest;
            Growth::new(one.value, if curved { rounding } else { rounding + apart })
        };
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
