//! Gauss's elimination of matrices that are mostly zero: those of orbits in many segments.

use nalgebra::{DMatrix, DVector};

/// The solution of a square system, with partial pivoting; `None` if its matrix is singular, or anything is not finite.
///
/// Rows that have a zero in the column of the pivot are left alone. Of an orbit in m segments of order N each column meets the
/// rows of two segments and those of the borders: the work is of the order (m N)² instead of (m N)³ (Ascher, Mattheij and
/// Russell 1995, ch. 7).
pub(crate) fn solved(matrix: &DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    let order = right.len();
    // Row i is column i here, so that it lies in one piece; its right side is its last element.
    let mut rows = matrix.transpose().insert_row(order, 0.0);
    rows.row_mut(order).copy_from(&right.transpose());
    eliminate(&mut rows)?;
    let mut solution = rows.row(order).transpose();
    for k in (0..order).rev() {
        solution[k] /= rows[(k, k)];
        for i in 0..k {
            solution[i] -= rows[(k, i)] * solution[k];
        }
    }
    solution.iter().all(|x| x.is_finite()).then_some(solution)
}

/// The sign of the determinant of a square matrix, ±1; `None` if it is singular, or anything is not finite.
pub(crate) fn orientation(matrix: &DMatrix<f64>) -> Option<f64> {
    eliminate(&mut matrix.transpose())
}

/// Makes rows, which are columns here, triangular; the sign of the determinant.
fn eliminate(rows: &mut DMatrix<f64>) -> Option<f64> {
    let mut sign = 1.0;
    for k in 0..rows.ncols() {
        let size = |i: usize| rows[(k, i)].abs();
        let larger = |pivot: usize, i: usize| if size(i) > size(pivot) { i } else { pivot };
        let pivot = (k..rows.ncols()).fold(k, larger);
        if !(size(pivot) > 0.0 && size(pivot).is_finite()) {
            return None;
        }
        if pivot != k {
            rows.swap_columns(k, pivot);
            sign = -sign;
        }
        let (upper, mut lower) = rows.columns_range_pair_mut(k, k + 1..);
        sign *= upper[k].signum();
        let inverse = 1.0 / upper[k];
        for mut row in lower.column_iter_mut() {
            let factor = row[k] * inverse;
            if factor != 0.0 {
                let mut rest = row.rows_range_mut(k + 1..);
                rest.axpy(-factor, &upper.rows_range(k + 1..), 1.0);
            }
        }
    }
    Some(sign)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_with_row_exchanges() {
        let matrix = DMatrix::from_row_slice(3, 3, &[0.0, 2.0, 1.0, 1.0, 1.0, 0.0, 4.0, 0.0, 3.0]);
        let solution = DVector::from_vec(vec![1.0, 2.0, 3.0]);
        let found = solved(&matrix, &(&matrix * &solution)).expect("it is regular");
        assert!((found - solution).amax() < 1e-14);
    }

    #[test]
    fn orientation_is_the_sign_of_the_determinant() {
        let matrix = DMatrix::from_row_slice(3, 3, &[0.0, 2.0, 1.0, 1.0, 1.0, 0.0, 4.0, 0.0, 3.0]);
        assert_eq!(orientation(&matrix), Some(-1.0));
        assert_eq!(orientation(&-matrix), Some(1.0));
        assert_eq!(orientation(&DMatrix::zeros(2, 2)), None);
    }

    #[test]
    fn what_has_no_single_solution_has_none() {
        let singular = DMatrix::from_row_slice(2, 2, &[1.0, 2.0, 2.0, 4.0]);
        let right = DVector::from_vec(vec![1.0, 0.0]);
        assert_eq!(solved(&singular, &right), None);
        let undefined = DMatrix::from_row_slice(2, 2, &[1.0, f64::NAN, 0.0, 1.0]);
        assert_eq!(solved(&undefined, &right), None);
    }
}
