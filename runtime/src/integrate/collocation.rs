//! The collocation polynomial of an implicit step: its predictor and its dense output.

use super::tableau::Tableau;
use crate::scalar::mapped;

/// The increment y(t + θh) − y(t) over one step, a polynomial of degree `S` in θ (Newton's form).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Collocation<const N: usize, const S: usize> {
    nodes: [f64; S],
    coefficients: [[f64; N]; S],
}

impl<const N: usize, const S: usize> Collocation<N, S> {
    /// The polynomial through 0 at θ = 0 and the stage increments at the nodes.
    pub(super) fn new(tableau: &Tableau<S>, increments: &[[f64; N]; S]) -> Self {
        let nodes = tableau.nodes;
        let mut coefficients: [[f64; N]; S] =
            crate::scalar::filled(|i| mapped(&increments[i], |increment| increment / nodes[i]));
        for order in 1..S {
            for i in (order..S).rev() {
                let width = nodes[i] - nodes[i - order];
                for j in 0..N {
                    coefficients[i][j] = (coefficients[i][j] - coefficients[i - 1][j]) / width;
                }
            }
        }
        Self {
            nodes,
            coefficients,
        }
    }

    /// The increment at the fraction `theta` of the step.
    #[must_use]
    pub fn at(&self, theta: f64) -> [f64; N] {
        let mut value = self.coefficients[S - 1];
        for i in (0..S - 1).rev() {
            let factor = theta - self.nodes[i];
            for j in 0..N {
                value[j] = self.coefficients[i][j] + factor * value[j];
            }
        }
        mapped(&value, |component| theta * component)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrate::tableau::RADAU_5;

    #[test]
    fn reproduces_a_polynomial_of_its_degree() {
        let cubic = |theta: f64| [theta * theta * theta - 2.0 * theta];
        let polynomial = Collocation::<1, 5>::new(&RADAU_5, &RADAU_5.nodes.map(cubic));
        for theta in [0.0, 0.1, 0.5, 1.0, 1.4] {
            assert!((polynomial.at(theta)[0] - cubic(theta)[0]).abs() < 1e-14);
        }
    }
}
