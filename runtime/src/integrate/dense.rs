//! The motion inside a step of DOP853: a polynomial of degree 7.

use super::carried::Carried;
use super::event::Bernstein;
use crate::scalar::mapped;

/// Number of coefficients above the value at the start.
pub(super) const TERMS: usize = 7;

/// The most that what each coefficient is multiplied by comes to: θ^(k/2+1) (1−θ)^((k+1)/2).
const MOST: [f64; TERMS] = [1.0, 0.25, 0.1482, 0.0625, 0.0346, 0.0157, 0.0084];

/// y(θ) for θ in [0, 1] along a step.
///
/// Stored as Hairer nests it: y₀ + θ(c₀ + (1−θ)(c₁ + θ(c₂ + (1−θ)(c₃ + ...)))).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dense<const N: usize> {
    from: [f64; N],
    length: f64,
    terms: [[f64; N]; TERMS],
}

impl<const N: usize> Dense<N> {
    /// From both ends of the step, the slopes there, and the four higher coefficients.
    pub(super) fn new(
        from: [f64; N],
        end: [f64; N],
        slopes: (&[f64; N], &[f64; N]),
        length: f64,
        higher: [[f64; N]; 4],
    ) -> Self {
        let mut terms = [[0.0; N]; TERMS];
        for i in 0..N {
            let rise = end[i] - from[i];
            terms[0][i] = rise;
            terms[1][i] = length * slopes.0[i] - rise;
            terms[2][i] = 2.0 * rise - length * (slopes.0[i] + slopes.1[i]);
        }
        terms[3..].copy_from_slice(&higher);
        Self::of_terms(from, length, terms)
    }

    /// From its terms.
    pub(super) fn of_terms(from: [f64; N], length: f64, terms: [[f64; N]; TERMS]) -> Self {
        Self {
            from,
            length,
            terms,
        }
    }

    /// The state at the beginning.
    pub(crate) fn start(&self) -> &[f64; N] {
        &self.from
    }

    /// The state at the end.
    pub(super) fn end(&self) -> [f64; N] {
        let mut end = self.from;
        end.add(1.0, &self.terms[0]);
        end
    }

    /// Its last term, what it has beyond a polynomial of degree 6.
    pub(super) fn last(&self) -> &[f64; N] {
        &self.terms[TERMS - 1]
    }

    /// Length of the step.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// The state at θ.
    #[must_use]
    pub fn state(&self, theta: f64) -> [f64; N] {
        let mut state = [0.0; N];
        for (k, term) in self.terms.iter().enumerate().rev() {
            let factor = if k % 2 == 0 { theta } else { 1.0 - theta };
            for i in 0..N {
                state[i] = (state[i] + term[i]) * factor;
            }
        }
        state.add(1.0, &self.from);
        state
    }

    /// The polynomial value + g·(y(θ) − y₀): an affine function of the state, from the product of g with a vector.
    #[must_use]
    pub fn along(&self, value: f64, gradient: impl Fn(&[f64; N]) -> f64) -> Bernstein {
        let projected = crate::scalar::filled(|k| gradient(&self.terms[k]));
        Bernstein::from_nested(value, projected)
    }

    /// Bounds of one state along the step.
    pub(crate) fn bounds(&self, index: usize) -> [f64; 2] {
        let from = self.from[index];
        let to = from + self.terms[0][index];
        let higher = self.terms.iter().zip(&MOST).skip(1);
        let off: f64 = higher.map(|(term, most)| term[index].abs() * most).sum();
        [from.min(to) - off, from.max(to) + off]
    }

    /// The rate of one state at the end of the step, for its length as the unit of time.
    pub(crate) fn leaves(&self, index: usize) -> f64 {
        self.terms[0][index] - self.terms[1][index] - self.terms[2][index]
    }

    /// The polynomial of one state.
    #[must_use]
    pub fn component(&self, index: usize) -> Bernstein {
        let projected = mapped(&self.terms, |term| term[index]);
        Bernstein::from_nested(self.from[index], projected)
    }
}
