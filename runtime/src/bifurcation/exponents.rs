//! Logarithms of multipliers that underflow: cyclic QR of the factors of Φ.

use nalgebra::DMatrix;

use crate::motion::Factor;

/// Sweeps of the cyclic QR; two already separate what is separable.
const SWEEPS: usize = 4;
/// A direction that a step damps by more than this (in e-folds) is not resolved by the step itself.
const DAMPED: f64 = 3.0;

/// ln|μ| and the sign of all multipliers, largest first, but for as many as are one: those nearest to it. A sign means nothing
/// where two moduli are one.
///
/// Where an implicit step damps a direction strongly, its own factor says little: an L-stable method
/// damps like a power where the motion damps exponentially. There (qᵀ ∫J dt q) of the direction q is used.
pub(super) fn exponents(factors: &[Factor], ones: usize) -> Vec<(f64, f64)> {
    let order = factors.first().map_or(0, |factor| factor.state.nrows());
    let mut basis = DMatrix::<f64>::identity(order, order);
    let mut sums = vec![(0.0, 1.0); order];
    for _ in 0..SWEEPS {
        sums.fill((0.0, 1.0));
        let first = basis.clone();
        for factor in factors {
            let qr = (&factor.state * &basis).qr();
            let before = std::mem::replace(&mut basis, qr.q());
            let r = qr.r();
            for (i, (log, sign)) in sums.iter_mut().enumerate() {
                let (rate, way) = rate(factor, [&before, &basis], i, r[(i, i)]);
                *log += rate;
                *sign *= way;
            }
        }
        for (i, (_, sign)) in sums.iter_mut().enumerate() {
            *sign *= first.column(i).dot(&basis.column(i)).signum();
        }
    }
    sums.sort_by(|(a, _), (b, _)| a.abs().total_cmp(&b.abs()));
    sums.drain(..ones.min(order));
    sums.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    sums
}

/// ln of what direction i of the basis is stretched by, and its sign.
fn rate(
    factor: &Factor,
    [before, after]: [&DMatrix<f64>; 2],
    i: usize,
    measured: f64,
) -> (f64, f64) {
    let q = after.column(i);
    let growth = factor.growth.as_ref();
    let integral = growth.map(|growth| (q.transpose() * growth * q)[(0, 0)]);
    match integral.filter(|integral| *integral < -DAMPED) {
        Some(integral) => (integral, before.column(i).dot(&q).signum()),
        None => (measured.abs().ln(), measured.signum()),
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
        let logs = exponents(&vec![factor; 200], 0);
        for ((log, sign), expected) in logs.iter().zip([2.0, -100.0, -600.0]) {
            assert!((log - expected).abs() < 1e-9 && *sign == 1.0, "{logs:?}");
        }
    }

    #[test]
    fn signs_are_those_of_the_product() {
        // Moduli 7e5, 0.3 and 1e-12, the first and the last negative: one factor for each, the last one turns all.
        let skew = DMatrix::from_row_slice(3, 3, &[1.0, 0.4, -0.2, 0.1, 1.0, 0.3, -0.5, 0.2, 1.0]);
        let back = skew.clone().try_inverse().unwrap();
        let factor = |all: [f64; 3]| {
            let diagonal = DMatrix::from_diagonal(&nalgebra::DVector::from_row_slice(&all));
            let state = &skew * diagonal * &back;
            Factor {
                state,
                growth: None,
            }
        };
        let signs = exponents(
            &[
                factor([-7e2, 0.6, 1e-6]),
                factor([1e3, -0.5, 1e-6]),
                factor([1.0, -1.0, -1.0]),
            ],
            0,
        );
        assert_eq!(
            signs.iter().map(|(_, sign)| *sign).collect::<Vec<_>>(),
            [-1.0, 1.0, -1.0]
        );
    }
}
