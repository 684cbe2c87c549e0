//! Units in which the rows and columns of a matrix are of one size.

use nalgebra::DMatrix;

/// A change of units that shrinks a row and its column together by less is not worth its sweep.
const WORTH: f64 = 0.95;
const SWEEPS: usize = 100;
/// Sizes farther apart than this stay so.
const FARTHEST: f64 = 1e200;

/// The matrix in other units, powers of 2, so that nothing is rounded: D⁻¹ A D, each row about as large as its column.
///
/// Eigenvalues stay, and their errors no longer depend on the units of the states (Parlett and Reinsch 1969). An entry
/// that is rounding error beside the rest of its row has no say: it would be made to look like something.
pub(crate) fn balanced(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let units = units(matrix);
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| {
        matrix[(i, j)] * (units[j] / units[i])
    })
}

/// D: in these units of the states each row is about as large as its column.
pub(crate) fn units(matrix: &DMatrix<f64>) -> Vec<f64> {
    let order = matrix.nrows();
    let mut units = vec![1.0; order];
    let mut sizes = matrix.map(f64::abs);
    for mut row in sizes.row_iter_mut() {
        let nothing = order as f64 * f64::EPSILON * row.max();
        row.apply(|size| *size = if *size > nothing { *size } else { 0.0 });
    }
    for _ in 0..SWEEPS {
        let mut changed = false;
        for i in 0..order {
            let unit = unit(&sizes, i);
            changed |= unit != 1.0;
            units[i] *= unit;
            sizes.row_mut(i).unscale_mut(unit);
            sizes.column_mut(i).scale_mut(unit);
        }
        if !changed {
            break;
        }
    }
    units
}

/// By what the column i is to be multiplied, and its row to be divided.
fn unit(sizes: &DMatrix<f64>, i: usize) -> f64 {
    let column = sizes.column(i).sum() - sizes[(i, i)];
    let row = sizes.row(i).sum() - sizes[(i, i)];
    let ratio = (row / column).sqrt();
    if !(ratio > 1.0 / FARTHEST && ratio < FARTHEST) {
        return 1.0;
    }
    let unit = ratio.log2().round().exp2();
    if column * unit + row / unit < WORTH * (column + row) {
        unit
    } else {
        1.0
    }
}
