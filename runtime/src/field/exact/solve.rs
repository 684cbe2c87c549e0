//! A small linear system over any scalar, restricted to a set of contacts.

use crate::scalar::Scalar;

/// Pivots below this part of the largest entry mean that forces are not unique.
const RANK: f64 = 1e-12;

/// Solves Σ_j G_ij x_j = x_i for i, j in `set`, in place: `rows` are used up, and x is left as it is elsewhere.
///
/// `None` if the matrix is singular or not finite there.
pub(crate) fn solve<R: AsRef<[D]> + AsMut<[D]>, D: Scalar>(
    rows: &mut [R],
    x: &mut [D],
    set: &[bool],
) -> Option<()> {
    let least = RANK * largest(rows, set);
    for column in members(set) {
        let pivot = pivot(rows, column, set);
        rows.swap(column, pivot);
        x.swap(column, pivot);
        let head = rows[column].as_ref()[column];
        // A comparison that fails for NaN too.
        let regular = head.re().abs() > least && head.re().is_finite();
        if !regular {
            return None;
        }
        let inverse = head.recip();
        for row in members(set) {
            if row <= column {
                continue;
            }
            let factor = rows[row].as_ref()[column] * inverse;
            for k in members(set) {
                if k > column {
                    let above = rows[column].as_ref()[k];
                    rows[row].as_mut()[k] -= factor * above;
                }
            }
            let above = x[column];
            x[row] -= factor * above;
        }
    }
    back_substitute(rows, x, set);
    Some(())
}

/// The numbers in a set, in their order.
fn members(set: &[bool]) -> impl DoubleEndedIterator<Item = usize> {
    (0..set.len()).filter(|&i| set[i])
}

/// Magnitude of the largest entry.
fn largest<R: AsRef<[D]>, D: Scalar>(rows: &[R], set: &[bool]) -> f64 {
    let mut largest: f64 = 0.0;
    for i in members(set) {
        for j in members(set) {
            largest = largest.max(rows[i].as_ref()[j].re().abs());
        }
    }
    largest
}

/// The row from `column` on whose entry there is the largest.
fn pivot<R: AsRef<[D]>, D: Scalar>(rows: &[R], column: usize, set: &[bool]) -> usize {
    let size = |i: usize| rows[i].as_ref()[column].re().abs();
    let mut pivot = column;
    for i in members(set) {
        if i > column && size(i).total_cmp(&size(pivot)).is_ge() {
            pivot = i;
        }
    }
    pivot
}

fn back_substitute<R: AsRef<[D]>, D: Scalar>(rows: &[R], x: &mut [D], set: &[bool]) {
    for i in members(set).rev() {
        let row = rows[i].as_ref();
        let mut sum = x[i];
        for k in members(set) {
            if k > i {
                sum -= row[k] * x[k];
            }
        }
        x[i] = sum / row[i];
    }
}
