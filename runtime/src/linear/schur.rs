//! Real Schur forms.

use nalgebra::{DMatrix, DVector, Schur};

/// Most iterations of QR in each of so many bases.
const ITERATIONS: usize = 1_000;
const BASES: usize = 8;

/// Q and T with A = Q T Qᵀ; `None` if QR ends in no basis.
///
/// QR may go round for ever where eigenvalues lie symmetrically about zero, as those of a system without damping do that
/// flutters: in another basis it ends.
pub(super) fn schur(matrix: &DMatrix<f64>) -> Option<(DMatrix<f64>, DMatrix<f64>)> {
    let order = matrix.nrows();
    if order == 1 {
        return Some((DMatrix::identity(1, 1), matrix.clone()));
    }
    (0..BASES).find_map(|trial| {
        let mirror = mirror(order, trial);
        let turned = &mirror * matrix * &mirror;
        let (basis, blocks) = Schur::try_new(turned, f64::EPSILON, ITERATIONS)?.unpack();
        Some((mirror * basis, blocks))
    })
}

/// The basis of a trial: first as it is, then reflected across planes that have nothing to do with any matrix.
fn mirror(order: usize, trial: usize) -> DMatrix<f64> {
    let identity = DMatrix::identity(order, order);
    if trial == 0 {
        return identity;
    }
    let normal = DVector::from_fn(order, |j, _| (1.3 * (trial * order + j) as f64).sin());
    let square = normal.norm_squared();
    identity - &normal * normal.transpose() * (2.0 / square)
}
