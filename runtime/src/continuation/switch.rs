//! The other branch at a point where two of them cross.

use crate::linear::svd;
use nalgebra::DVector;

use super::Linearisation;
use super::corrector::bordered;

/// The unit vector (scaled, r last) in the kernel of [h_z h_r] that is orthogonal to the branch `along`.
///
/// At a simple branch point that kernel has two dimensions: the tangents of both branches span it. The
/// other branch meets the plane across this vector at any small distance, and the branch itself does
/// not, so that the corrector finds the right one there. `None` where the kernel cannot be computed.
#[must_use]
pub fn across<Extra>(
    linearisation: &Linearisation<Extra>,
    scale: &DVector<f64>,
    r_scale: f64,
    along: &DVector<f64>,
) -> Option<DVector<f64>> {
    let n = scale.len();
    let svd = svd(bordered(
        linearisation,
        scale,
        r_scale,
        &DVector::zeros(n + 1),
    ))?;
    let rows = svd.v_t?;
    let mut order: Vec<usize> = (0..=n).collect();
    order.sort_by(|&a, &b| svd.singular_values[a].total_cmp(&svd.singular_values[b]));
    let [first, second, ..] = order.as_slice() else {
        return None;
    };
    let [u, v] = [*first, *second].map(|i| rows.row(i).transpose());
    let (a, b) = (along.dot(&u), along.dot(&v));
    let direction = (u * -b + v * a).try_normalize(f64::EPSILON)?;
    direction.iter().all(|x| x.is_finite()).then_some(direction)
}

#[cfg(test)]
mod tests {
    use nalgebra::DMatrix;

    use super::*;

    #[test]
    fn the_kernel_across_the_branch_is_found() {
        // z₁ (r − z₁²) = 0 and z₂ = r, at the origin: the branch z₁ = 0 runs along (0, 1, 1).
        let linearisation = Linearisation {
            residual: DVector::zeros(2),
            jacobian: DMatrix::from_row_slice(2, 2, &[0.0, 0.0, 0.0, 1.0]),
            design: DVector::from_vec(vec![0.0, -1.0]),
            extra: (),
        };
        let scale = DVector::from_element(2, 1.0);
        let along = DVector::from_vec(vec![0.0, 1.0, 1.0]).normalize();
        let across = across(&linearisation, &scale, 1.0, &along).unwrap();
        assert!((across[0].abs() - 1.0).abs() < 1e-14, "{across}");
    }
}
