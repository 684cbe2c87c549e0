//! Small motions that contacts leave free, without those from one equilibrium of a set to another.

use nalgebra::DMatrix;

use crate::linear::balanced;

/// Share of the largest entry below which another is rounding error.
const NOTHING: f64 = 1e-9;

/// The matrix on the vectors for which these rows vanish, which it maps into each other.
pub(super) fn restricted(matrix: &DMatrix<f64>, rows: &DMatrix<f64>) -> DMatrix<f64> {
    let mut rows = rows.clone();
    for mut row in rows.row_iter_mut() {
        let size = row.amax();
        row /= if size > 0.0 { size } else { 1.0 };
    }
    let rows = Solved::of(&rows, rows.nrows());
    let left = |i: usize, j: usize| {
        let bound = rows.pivots.iter().enumerate();
        let moved = bound.map(|(k, pivot)| matrix[(i, *pivot)] * rows.rows[(k, j)]);
        matrix[(i, j)] - moved.sum::<f64>()
    };
    let free = rows.free();
    DMatrix::from_fn(free.len(), free.len(), |i, j| left(free[i], free[j]))
}

/// The matrix with all vectors taken as one that differ by its kernel, which has this dimension. A zero eigenvalue that is
/// left tells that something moves along the kernel.
pub(super) fn modulo_kernel(matrix: &DMatrix<f64>, dimension: usize) -> DMatrix<f64> {
    let matrix = balanced(matrix);
    let rank = matrix.nrows().saturating_sub(dimension);
    let kernel = Solved::of(&matrix, rank).kernel();
    restricted(&matrix.transpose(), &kernel).transpose()
}

/// Equations solved for as many unknowns, the pivots, by Gauss and Jordan.
struct Solved {
    rows: DMatrix<f64>,
    pivots: Vec<usize>,
}

impl Solved {
    /// Of so many of these equations, those that hold most; fewer if the others follow from them.
    fn of(equations: &DMatrix<f64>, count: usize) -> Self {
        let mut rows = equations.clone();
        let largest = rows.amax();
        let mut pivots = Vec::new();
        for k in 0..count.min(rows.nrows()).min(rows.ncols()) {
            let (i, j) = rows.rows_range(k..).map(f64::abs).iamax_full();
            let (i, head) = (i + k, rows[(i + k, j)]);
            // A comparison that fails for NaN too.
            let tells = head.abs() > NOTHING * largest;
            if !tells {
                break;
            }
            rows.swap_rows(k, i);
            let row = rows.row(k) / head;
            for other in 0..rows.nrows() {
                let change = &row * rows[(other, j)];
                let solved = if other == k {
                    row.clone()
                } else {
                    rows.row(other) - change
                };
                rows.set_row(other, &solved);
            }
            pivots.push(j);
        }
        Self { rows, pivots }
    }

    /// The unknowns that may have any value.
    fn free(&self) -> Vec<usize> {
        let all = 0..self.rows.ncols();
        all.filter(|j| !self.pivots.contains(j)).collect()
    }

    /// Solutions that span all, in rows.
    fn kernel(&self) -> DMatrix<f64> {
        let free = self.free();
        DMatrix::from_fn(free.len(), self.rows.ncols(), |f, j| {
            match self.pivots.iter().position(|pivot| *pivot == j) {
                Some(k) => -self.rows[(k, free[f])],
                None => f64::from(u8::from(free[f] == j)),
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_drifts_along_a_set_has_a_zero_eigenvalue() {
        let (gain, lag) = (2.0, 10.0);
        // x, v, h and i of a valve that sticks between a tank and its controller.
        let rows = [
            [0.0, 1.0, 0.0, 0.0],
            [0.0, 0.0, 0.0, 0.0],
            [gain / lag, 0.0, -1.0 / lag, 0.0],
            [0.0, 0.0, -1.0, 0.0],
        ];
        let jacobian = DMatrix::from_row_slice(4, 4, rows.as_flattened());
        let speed = DMatrix::from_row_slice(1, 4, &[0.0, 1.0, 0.0, 0.0]);
        let left = modulo_kernel(&restricted(&jacobian, &speed), 1);
        assert_eq!(left.shape(), (2, 2));
        assert_eq!(left.determinant(), 0.0);
        assert!((left.trace() + 1.0 / lag).abs() < 1e-15);
    }
}
