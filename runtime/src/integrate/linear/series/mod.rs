//! The Taylor series of a linear motion.

use crate::field::{LinearField, Point};
use crate::integrate::dense::TERMS;

/// Highest degree.
const DEGREE: usize = 24;
/// Part of its scale below which a term is nothing.
const NOTHING: f64 = 1e-18;
/// Terms beyond that of the fastest motion alone: where motions of one rate drive each other, terms fall later.
const MORE: usize = 2;
/// Terms that any series has: so many a field has that does nothing but shift.
const FEWEST: usize = 9;
/// Where the dense output meets the series inside a step, beside its mirror image: as far off between as possible.
const MEETING: f64 = 0.3614;

/// So many terms are needed where the fastest motion goes this far.
pub(super) fn degree(reach: f64) -> usize {
    let (mut term, mut degree) = (1.0, 0);
    while (term > NOTHING || degree + MORE < FEWEST) && degree + MORE < DEGREE {
        degree += 1;
        term *= reach / degree as f64;
    }
    degree + MORE
}

/// yₖ = y⁽ᵏ⁾ hᵏ/k!, the terms of y(θ h) = Σ yₖ θᵏ.
#[derive(Debug, Clone, Copy)]
pub(super) struct Series<const N: usize> {
    terms: [[f64; N]; DEGREE + 1],
    degree: usize,
}

impl<const N: usize> Series<N> {
    /// From this point for the time `length`.
    pub(super) fn new(
        field: &LinearField<N>,
        start: &Point<N>,
        length: f64,
        degree: usize,
    ) -> Self {
        let mut terms = [[0.0; N]; DEGREE + 1];
        let mut point = *start;
        terms[0] = point.0;
        for (inverse, term) in INVERSE[1..=degree].iter().zip(&mut terms[1..]) {
            point = field.next(length * inverse, &point);
            *term = point.0;
        }
        Self { terms, degree }
    }

    /// y(θ h).
    pub(super) fn state(&self, theta: f64) -> [f64; N] {
        let mut state = self.terms[self.degree];
        for term in self.terms[..self.degree].iter().rev() {
            for (y, t) in state.iter_mut().zip(term) {
                *y = *y * theta + t;
            }
        }
        state
    }

    /// yₖ.
    pub(super) fn term(&self, k: usize) -> &[f64; N] {
        &self.terms[k]
    }

    /// y(h) − y(0).
    pub(super) fn rise(&self) -> [f64; N] {
        let mut rise = [0.0; N];
        for term in self.from(1) {
            add(&mut rise, 1.0, term);
        }
        rise
    }

    /// The terms of the dense output: of the polynomial of degree 7 with value, slope and curvature of y at both ends.
    pub(super) fn path(&self) -> [[f64; N]; TERMS] {
        let (rise, first) = (self.rise(), self.terms[1]);
        let mut path = [[0.0; N]; TERMS];
        for (j, rise) in rise.iter().enumerate() {
            path[0][j] = *rise;
            path[1][j] = first[j] - rise;
            path[2][j] = 2.0 * rise - first[j];
        }
        for (k, term) in self.from(1).iter().enumerate() {
            add(&mut path[2], -((k + 1) as f64), term);
        }
        for (term, weights) in self.from(4).iter().zip(&HIGHER[4..]) {
            for (sum, weight) in path[3..].iter_mut().zip(weights) {
                add(sum, *weight, term);
            }
        }
        path
    }

    /// The terms from this degree on.
    fn from(&self, k: usize) -> &[[f64; N]] {
        &self.terms[k..=self.degree]
    }
}

/// ∂y(h)/∂r, where the point from which the motion begins does not depend on r.
pub(super) fn design<const N: usize>(
    field: &LinearField<N>,
    start: &Point<N>,
    length: f64,
    degree: usize,
) -> [f64; N] {
    let (mut point, mut slope) = (*start, ([0.0; N], [0.0; 3]));
    let mut sum = [0.0; N];
    for inverse in &INVERSE[1..=degree] {
        let factor = length * inverse;
        slope = field.next_design(factor, &slope, &point);
        point = field.next(factor, &point);
        add(&mut sum, 1.0, &slope.0);
    }
    sum
}

/// 1 in one place, 0 in the others.
pub(super) fn unit<const K: usize>(j: usize) -> [f64; K] {
    crate::scalar::filled(|i| f64::from(i == j))
}

#[inline]
pub(super) fn add<const N: usize>(sum: &mut [f64; N], factor: f64, term: &[f64; N]) {
    for (s, t) in sum.iter_mut().zip(term) {
        *s += factor * t;
    }
}

/// 1/k.
const INVERSE: [f64; DEGREE + 1] = {
    let mut inverse = [0.0; DEGREE + 1];
    let mut k = 1;
    while k <= DEGREE {
        inverse[k] = 1.0 / k as f64;
        k += 1;
    }
    inverse
};

/// The higher terms of the dense output of θᵏ: it has value, slope and curvature of that at 0 and 1, and its value at
/// [`MEETING`] and its mirror image.
const HIGHER: [[f64; 4]; DEGREE + 1] = {
    let mut all = [[0.0; 4]; DEGREE + 1];
    let mut k = 4;
    while k <= DEGREE {
        all[k] = higher(k);
        k += 1;
    }
    all
};

const fn higher(k: usize) -> [f64; 4] {
    let (a, b) = (MEETING, 1.0 - MEETING);
    let (at_zero, at_one) = (remainder(k, 0.0), remainder(k, 1.0));
    let first = at_one - at_zero;
    let left = (remainder(k, a) - at_zero - a * first) / (a * b);
    let right = (remainder(k, b) - at_zero - b * first) / (a * b);
    let last = (right - left) / (b - a);
    [at_zero, first, left - a * last, last]
}

/// What is left of θᵏ beside the cubic with its values and slopes at 0 and 1, over θ²(1 − θ)²: Σ (k − 3 − j) θʲ, a divided
/// difference.
const fn remainder(k: usize, theta: f64) -> f64 {
    let (mut sum, mut power, mut j) = (0.0, 1.0, 0);
    while j + 4 <= k {
        sum += (k - 3 - j) as f64 * power;
        power *= theta;
        j += 1;
    }
    sum
}

#[cfg(test)]
mod tests;
