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
    let form = |matrix| Some(Schur::try_new(matrix, f64::EPSILON, ITERATIONS)?.unpack());
    form(matrix.clone()).or_else(|| {
        (1..BASES).find_map(|trial| {
            let mirror = mirror(order, trial);
            let (basis, blocks) = form(&mirror * matrix * &mirror)?;
            Some((mirror * basis, blocks))
        })
    })
}

/// The basis of a trial: reflected across a plane that has nothing to do with any matrix.
fn mirror(order: usize, trial: usize) -> DMatrix<f64> {
    let normal = DVector::from_fn(order, |j, _| (1.3 * (trial * order + j) as f64).sin());
    let square = normal.norm_squared();
    DMatrix::identity(order, order) - &normal * normal.transpose() * (2.0 / square)
}
