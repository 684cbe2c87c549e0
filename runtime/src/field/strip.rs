//! Rows and columns that are zero but for a stretch: a contact reads and pushes few states.

use std::ops::Range;

use crate::model::Model;
use crate::scalar::{Inline, Scalar, filled};

/// Number of states up to which all entries are taken: a loop of known length is faster than a short one.
const FEW: usize = 8;

/// A vector with one entry for each state, of which only a stretch differs from zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Strip<const N: usize> {
    entries: [f64; N],
    first: usize,
    end: usize,
}

impl<const N: usize> Strip<N> {
    /// Nothing but zeros.
    pub(crate) const ZERO: Self = Self {
        entries: [0.0; N],
        first: 0,
        end: 0,
    };

    /// A row or a column of a matrix: where states are few, it is not looked at which of them differ from zero.
    pub(crate) fn of_matrix(entries: [f64; N]) -> Self {
        if N > FEW {
            return entries.into();
        }
        Self {
            entries,
            first: 0,
            end: N,
        }
    }

    /// All entries.
    pub(crate) fn entries(&self) -> &[f64; N] {
        &self.entries
    }

    /// The one state that it reads, if it reads one only.
    #[inline]
    pub(crate) fn only(&self) -> Option<usize> {
        (self.first + 1 == self.end).then_some(self.first)
    }

    /// Clears the one state that it reads, if it reads one only: where there are few, none is chosen by its number, which
    /// would keep a small vector out of the registers.
    #[inline]
    pub(crate) fn clear_only<D: Scalar>(&self, vector: &mut [D; N]) {
        let Some(only) = self.only() else {
            return;
        };
        if N <= FEW {
            for (state, x) in vector.iter_mut().enumerate() {
                if state == only {
                    *x = D::from(0.0);
                }
            }
        } else {
            vector[only] = D::from(0.0);
        }
    }

    #[inline]
    fn stretch(&self) -> Range<usize> {
        if N <= FEW { 0..N } else { self.first..self.end }
    }

    /// The entries that may differ from zero, with their numbers.
    #[inline]
    pub(crate) fn iter(&self) -> impl Iterator<Item = (usize, f64)> {
        let stretch = self.stretch();
        let entries = self.entries[stretch.clone()].iter().copied();
        stretch.zip(entries)
    }

    /// The product with a vector of any scalar.
    #[inline]
    pub(crate) fn dot<D: Scalar>(&self, vector: &[D; N]) -> D {
        let stretch = self.stretch();
        let (vector, entries) = (&vector[stretch.clone()], &self.entries[stretch]);
        let sum = |vector: &[D], entries: &[f64]| {
            let pairs = vector.iter().zip(entries);
            pairs.fold(D::from(0.0), |sum, (x, g)| sum + *x * *g)
        };
        if N <= FEW {
            return sum(vector, entries);
        }
        // Side by side, as no product waits for the one before it then.
        let (fours, rest) = vector.as_chunks::<4>();
        let (others, last) = entries.as_chunks::<4>();
        let mut sums = [D::from(0.0); 4];
        for (four, other) in fours.iter().zip(others) {
            for (sum, (x, g)) in sums.iter_mut().zip(four.iter().zip(other)) {
                *sum += *x * *g;
            }
        }
        sums[0] + sums[1] + (sums[2] + sums[3]) + sum(rest, last)
    }

    /// The magnitude of the terms of a number of this value at a state, of which this is the gradient: what its rounding
    /// error is measured against.
    pub(crate) fn terms(&self, value: f64, state: &[f64; N]) -> f64 {
        let terms = || self.iter().map(|(j, slope)| slope * state[j]);
        let rest = value - terms().sum::<f64>();
        terms().map(f64::abs).sum::<f64>() + rest.abs()
    }

    /// Adds a multiple of it to another one.
    pub(crate) fn add_to_strip(&self, sum: &mut Self, times: f64) {
        self.add_to(&mut sum.entries, times);
        if self.first < self.end {
            let empty = sum.first == sum.end;
            sum.first = if empty {
                self.first
            } else {
                sum.first.min(self.first)
            };
            sum.end = sum.end.max(self.end);
        }
    }

    /// Adds a multiple of it to a vector of any scalar.
    #[inline]
    pub(crate) fn add_to<D: Scalar>(&self, vector: &mut [D; N], times: D) {
        let stretch = self.stretch();
        for (x, b) in vector[stretch.clone()]
            .iter_mut()
            .zip(&self.entries[stretch])
        {
            *x += times * *b;
        }
    }
}

impl<const N: usize> From<[f64; N]> for Strip<N> {
    fn from(entries: [f64; N]) -> Self {
        let differs = |entry: &f64| *entry != 0.0;
        let first = entries.iter().position(differs).unwrap_or(0);
        let end = entries.iter().rposition(differs).map_or(0, |last| last + 1);
        Self {
            entries,
            first,
            end,
        }
    }
}

/// The rows of a matrix with one row for each contact, of which `column` makes what is in place of each state's unit vector.
pub(crate) fn rows<M: Model<N>, const N: usize>(
    column: impl Fn(&[f64; N]) -> M::PerContact<f64>,
) -> M::PerContact<Strip<N>> {
    let mut rows: M::PerContact<[f64; N]> = Inline::from_fn(|_| [0.0; N]);
    for j in 0..N {
        let column = column(&filled(|i| f64::from(i == j)));
        for (row, entry) in rows.as_mut().iter_mut().zip(column.as_ref()) {
            row[j] = *entry;
        }
    }
    Inline::from_fn(|i| rows.as_ref()[i].into())
}
