//! Singular values of matrices that may be anything.

use nalgebra::{DMatrix, Dyn, SVD};

/// Rounds in which singular values are found, or not at all.
const ROUNDS: usize = 10_000;

/// The singular values of a matrix with their vectors; `None` where they are not found, as of one that is not finite, or
/// whose squares are not.
pub(crate) fn svd(matrix: DMatrix<f64>) -> Option<SVD<f64, Dyn, Dyn>> {
    let finite = matrix.iter().all(|entry| entry.is_finite());
    finite
        .then(|| SVD::try_new(matrix, true, true, f64::EPSILON, ROUNDS))
        .flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_matrix_gets_an_answer() {
        for entry in [f64::NAN, f64::INFINITY, 1e300, 0.0, 5e-324] {
            let mut matrix = DMatrix::identity(4, 4);
            matrix[(1, 2)] = entry;
            matrix[(3, 0)] = -entry;
            let least = svd(matrix).map(|svd| svd.singular_values.min());
            assert!(
                least.is_none_or(|least| least >= 0.0),
                "{entry:e}: {least:?}"
            );
        }
    }
}
