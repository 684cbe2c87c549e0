//! Eigenvalues of an equilibrium, and what they say.

use nalgebra::{Complex, DMatrix};

use crate::bifurcation::Stability;
use crate::linear::eigenvalues;

/// Real parts below this many rounding errors of the Jacobian have no sign.
const ROUNDING: f64 = 64.0;

/// The eigenvalues of a Jacobian.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// Largest real part first; empty if they could not be found.
    pub eigenvalues: Vec<Complex<f64>>,
    /// How many have a positive real part.
    pub unstable: usize,
    /// What they say together.
    pub stability: Stability,
}

impl Spectrum {
    /// Of an n × n Jacobian.
    #[must_use]
    pub fn of(jacobian: &DMatrix<f64>) -> Self {
        Self::judged(eigenvalues(jacobian), rounding(jacobian))
    }

    /// The same without the `neutral` eigenvalues that are zero because an equilibrium belongs to a set, and
    /// because contacts stick.
    #[must_use]
    pub fn across(jacobian: &DMatrix<f64>, neutral: usize) -> Self {
        let mut all = eigenvalues(jacobian);
        all.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
        all.truncate(jacobian.nrows().saturating_sub(neutral));
        Self::judged(all, rounding(jacobian))
    }

    fn judged(mut eigenvalues: Vec<Complex<f64>>, rounding: f64) -> Self {
        eigenvalues.sort_by(|a, b| b.re.total_cmp(&a.re).then(b.im.total_cmp(&a.im)));
        let count = |wanted: &dyn Fn(f64) -> bool| {
            eigenvalues.iter().filter(|value| wanted(value.re)).count()
        };
        let clearly = count(&|re| re > rounding);
        let stability = if clearly > 0 {
            Stability::Unstable
        } else if count(&|re| re.abs() <= rounding) > 0 {
            Stability::Undecided
        } else {
            Stability::Stable
        };
        Self {
            unstable: count(&|re| re > 0.0),
            stability,
            eigenvalues,
        }
    }

    /// Π (λᵢ + λⱼ) over i < j, each factor relative to |λᵢ| + |λⱼ|: changes sign at a Hopf point and at a neutral saddle.
    #[must_use]
    pub fn hopf_test(&self) -> f64 {
        let factors = self.pairs().map(|(a, b)| (a + b) / size(a, b));
        factors.product::<Complex<f64>>().re
    }

    /// |Im λ| of the pair whose sum is nearest to zero; `None` if that pair is real: a neutral saddle.
    #[must_use]
    pub fn critical_frequency(&self) -> Option<f64> {
        let sum =
            |pair: &(Complex<f64>, Complex<f64>)| (pair.0 + pair.1).norm() / size(pair.0, pair.1);
        let nearest = self.pairs().min_by(|a, b| sum(a).total_cmp(&sum(b)))?;
        let frequency = nearest.0.im.abs();
        (frequency > 0.0 && nearest.0.im == -nearest.1.im).then_some(frequency)
    }

    fn pairs(&self) -> impl Iterator<Item = (Complex<f64>, Complex<f64>)> + '_ {
        let all = &self.eigenvalues;
        let later = move |i: usize| all[i + 1..].iter().map(move |b| (all[i], *b));
        (0..all.len()).flat_map(later)
    }
}

fn size(a: Complex<f64>, b: Complex<f64>) -> f64 {
    (a.norm() + b.norm()).max(f64::MIN_POSITIVE)
}

fn rounding(jacobian: &DMatrix<f64>) -> f64 {
    ROUNDING * f64::EPSILON * jacobian.norm()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Eigenvalues a ± 2i, 1 and −1: the last two are a neutral saddle unless a is nearer to zero.
    fn spectrum(a: f64, c: f64) -> Spectrum {
        let rows = [
            a, -2.0, 0.0, 0.0, 2.0, a, 0.0, 0.0, 0.0, 0.0, 1.0, 0.3, 0.0, 0.0, 0.0, c,
        ];
        Spectrum::of(&DMatrix::from_row_slice(4, 4, &rows))
    }

    #[test]
    fn a_pair_that_crosses_changes_the_sign_of_the_test() {
        let (before, after) = (spectrum(-1e-3, -3.0), spectrum(1e-3, -3.0));
        assert!(before.hopf_test() * after.hopf_test() < 0.0);
        assert_eq!((before.unstable, after.unstable), (1, 3));
        assert!((after.critical_frequency().unwrap() - 2.0).abs() < 1e-12);
    }

    #[test]
    fn a_neutral_saddle_has_no_frequency() {
        let (before, after) = (spectrum(-0.5, -1.001), spectrum(-0.5, -0.999));
        assert!(before.hopf_test() * after.hopf_test() < 0.0);
        assert_eq!(after.critical_frequency(), None);
    }

    #[test]
    fn a_centre_is_undecided() {
        let centre = Spectrum::of(&DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -1.0, 0.0]));
        assert_eq!(centre.stability, Stability::Undecided);
    }
}
