//! Vectors with few entries that span the same as others.

use nalgebra::{DMatrix, DVector};

/// Share of the largest entry below which another is none.
const NONE: f64 = 1e-8;

/// A direction, with the number of the state that no other one moves.
pub(super) type Free = (usize, Vec<f64>);

/// The reduced rows of vectors given in units of the states: each is the only one to hold the state of its pivot.
pub(super) struct Echelon {
    rows: DMatrix<f64>,
    pivots: Vec<usize>,
}

impl Echelon {
    /// Those of vectors of at least so many entries; of the states `first` each is a pivot, while there are any.
    pub(super) fn of(span: &[DVector<f64>], order: usize, first: &[usize]) -> Self {
        let mut rows = DMatrix::from_fn(span.len(), order, |i, j| span[i][j]);
        let mut left = first.to_vec();
        let mut pivots = Vec::new();
        for i in 0..rows.nrows() {
            let size = |j: &usize| rows[(i, *j)].abs();
            let preferred = left
                .iter()
                .copied()
                .max_by(|a, b| size(a).total_cmp(&size(b)));
            let preferred = preferred.filter(|j| size(j) > NONE);
            let pivot = preferred.unwrap_or_else(|| rows.row(i).transpose().iamax());
            left.retain(|j| *j != pivot);
            let head = rows[(i, pivot)];
            let row = rows.row(i) / if head == 0.0 { 1.0 } else { head };
            rows.set_row(i, &row);
            for other in (0..rows.nrows()).filter(|&other| other != i) {
                let change = rows.row(other) - &row * rows[(other, pivot)];
                rows.set_row(other, &change);
            }
            pivots.push(pivot);
        }
        Self { rows, pivots }
    }

    /// As conditions c·x on states of these magnitudes.
    pub(super) fn conditions(&self, magnitude: &[f64]) -> Vec<Vec<f64>> {
        self.entries(|j, share| share / magnitude[j])
    }

    /// As directions in which states of these magnitudes move.
    pub(super) fn directions(&self, magnitude: &[f64]) -> Vec<Free> {
        let directions = self.entries(|j, share| share * magnitude[j]);
        self.pivots.iter().copied().zip(directions).collect()
    }

    /// Of each row the largest entry is 1 or −1, and the first is positive.
    fn entries(&self, entry: impl Fn(usize, f64) -> f64) -> Vec<Vec<f64>> {
        let heard = |share: f64| if share.abs() > NONE { share } else { 0.0 };
        let rows = self.rows.row_iter();
        let entries = rows.map(|row| {
            let shares = row.iter().enumerate();
            normalised(shares.map(|(j, share)| entry(j, heard(*share))).collect())
        });
        entries.collect()
    }
}

fn normalised(combination: Vec<f64>) -> Vec<f64> {
    let largest = combination
        .iter()
        .fold(0.0_f64, |most, c| most.max(c.abs()));
    let first = combination.iter().find(|c| **c != 0.0);
    let size = largest.copysign(first.copied().unwrap_or(1.0));
    combination.iter().map(|c| c / size).collect()
}
