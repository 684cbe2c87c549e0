//! Logarithms of multipliers that underflow: cyclic QR of the factors of Φ.

use nalgebra::DMatrix;

use crate::motion::Factor;

/// Sweeps of the cyclic QR; two already separate what is separable.
const SWEEPS: usize = 4;
/// A direction that a step damps by more than this (in e-folds) is not resolved by the step itself.
const DAMPED: f64 = 3.0;

/// ln|μ| of all N multipliers, the trivial one included, largest first.
///
/// Where an implicit step damps a direction strongly, its own factor says little: an L-stable method
/// damps like a power where the motion damps exponentially. There (qᵀ ∫J dt q) of the direction q is used.
pub(super) fn exponents(factors: &[Factor]) -> Vec<f64> {
    let order = factors.first().map_or(0, |factor| factor.state.nrows());
    let mut basis = DMatrix::<f64>::identity(order, order);
    let mut sums = vec![0.0; order];
    for _ in 0..SWEEPS {
        sums.fill(0.0);
        for factor in factors {
            let qr = (&factor.state * &basis).qr();
            basis = qr.q();
            let r = qr.r();
            for (i, sum) in sums.iter_mut().enumerate() {
                *sum += rate(factor, &basis, i, r[(i, i)].abs().ln());
            }
        }
    }
    sums.sort_by(|a, b| b.total_cmp(a));
    sums
}

/// ln of what direction i of the basis is stretched by.
fn rate(factor: &Factor, basis: &DMatrix<f64>, i: usize, measured: f64) -> f64 {
    let Some(growth) = &factor.growth else {
        return measured;
    };
    let q = basis.column(i);
    let integral = (q.transpose() * growth * q)[(0, 0)];
    if integral < -DAMPED {
        integral
    } else {
        measured
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widely_separated_moduli_are_recovered() {
        // 200 equal factors with moduli e^0.01, e^−0.5 and e^−3 each, in a skew basis.
        let skew = DMatrix::from_row_slice(3, 3, &[1.0, 0.4, -0.2, 0.1, 1.0, 0.3, -0.5, 0.2, 1.0]);
        let moduli = [0.01_f64.exp(), (-0.5_f64).exp(), (-3.0_f64).exp()];
        let diagonal = DMatrix::from_diagonal(&nalgebra::DVector::from_vec(moduli.to_vec()));
        let product = &skew * diagonal * skew.clone().try_inverse().unwrap();
        let factor = Factor {
            state: product,
            growth: None,
        };
        let logs = exponents(&vec![factor; 200]);
        for (log, expected) in logs.iter().zip([2.0, -100.0, -600.0]) {
            assert!((log - expected).abs() < 1e-9, "{logs:?}");
        }
    }
}
