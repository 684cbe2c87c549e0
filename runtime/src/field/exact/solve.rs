//! A small linear system over any scalar, restricted to a set of contacts.

use crate::model::Model;
use crate::scalar::Scalar;

/// Pivots below this part of the largest entry mean that forces are not unique.
const RANK: f64 = 1e-12;

/// Solves Σ_j G_ij x_j = rhs_i for i, j in `set`; elsewhere x is `rhs`.
///
/// `None` if the matrix is singular or not finite there.
pub(crate) fn solve<M: Model<N>, D: Scalar, const N: usize>(
    mut matrix: M::PerContact<M::PerContact<D>>,
    mut rhs: M::PerContact<D>,
    set: impl Fn(usize) -> bool,
) -> Option<M::PerContact<D>> {
    let rows = matrix.as_mut();
    let x = rhs.as_mut();
    let contacts = x.len();
    let members = || (0..contacts).filter(|&i| set(i));
    let largest = members()
        .flat_map(|i| members().map(move |j| (i, j)))
        .map(|(i, j)| rows[i].as_ref()[j].re().abs())
        .fold(0.0, f64::max);
    for column in members() {
        let rest = members().filter(|&i| i >= column);
        let pivot = rest.max_by(|&a, &b| {
            let size = |i: usize| rows[i].as_ref()[column].re().abs();
            size(a).total_cmp(&size(b))
        })?;
        rows.swap(column, pivot);
        x.swap(column, pivot);
        let head = rows[column].as_ref()[column];
        // A comparison that fails for NaN too.
        let regular = head.re().abs() > RANK * largest && head.re().is_finite();
        if !regular {
            return None;
        }
        let inverse = head.recip();
        for row in members().filter(|&i| i > column) {
            let factor = rows[row].as_ref()[column] * inverse;
            for k in members().filter(|&k| k > column) {
                let above = rows[column].as_ref()[k];
                rows[row].as_mut()[k] -= factor * above;
            }
            let above = x[column];
            x[row] -= factor * above;
        }
    }
    back_substitute::<M, D, N>(rows, x, &set);
    Some(rhs)
}

fn back_substitute<M: Model<N>, D: Scalar, const N: usize>(
    rows: &[M::PerContact<D>],
    x: &mut [D],
    set: &impl Fn(usize) -> bool,
) {
    let contacts = x.len();
    for i in (0..contacts).rev().filter(|&i| set(i)) {
        let row = rows[i].as_ref();
        let mut sum = x[i];
        for k in (i + 1..contacts).filter(|&k| set(k)) {
            sum -= row[k] * x[k];
        }
        x[i] = sum / row[i];
    }
}
