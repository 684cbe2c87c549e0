//! Test functions of smooth bifurcations, on the multipliers of the section map.

use nalgebra::Complex;

/// det(I − DP), scaled to [−1, 1]: changes sign at a fold and at a branch point, and not where a multiplier comes that is 0.
#[must_use]
pub fn fold(multipliers: &[Complex<f64>]) -> f64 {
    product(multipliers.iter().map(|mu| (1.0 - mu) / (mu.norm() + 1.0)))
}

/// det(DP + I), scaled to [−1, 1]: changes sign at a flip.
#[must_use]
pub fn flip(multipliers: &[Complex<f64>]) -> f64 {
    product(multipliers.iter().map(|mu| (mu + 1.0) / (mu.norm() + 1.0)))
}

/// ∏ᵢ﹤ⱼ (μᵢ μⱼ − 1), scaled to [−1, 1]: changes sign at a torus point, and at a neutral saddle.
#[must_use]
pub fn torus(multipliers: &[Complex<f64>]) -> f64 {
    product(pairs(multipliers).map(|(a, b)| (a * b - 1.0) / ((a * b).norm() + 1.0)))
}

fn pairs(multipliers: &[Complex<f64>]) -> impl Iterator<Item = (Complex<f64>, Complex<f64>)> + '_ {
    let later = |i: usize| multipliers[i + 1..].iter();
    let all = multipliers.iter().enumerate();
    all.flat_map(move |(i, a)| later(i).map(move |b| (*a, *b)))
}

/// A product over all of a conjugate set: real.
fn product(factors: impl Iterator<Item = Complex<f64>>) -> f64 {
    factors
        .fold(Complex::new(1.0, 0.0), |all, factor| all * factor)
        .re
}

#[cfg(test)]
mod tests {
    use super::*;

    fn real(values: &[f64]) -> Vec<Complex<f64>> {
        values.iter().map(|&x| Complex::new(x, 0.0)).collect()
    }

    #[test]
    fn signs_change_where_multipliers_pass_the_circle() {
        assert!(fold(&real(&[0.99, 0.0])) * fold(&real(&[1.01, 0.0])) < 0.0);
        assert!(flip(&real(&[-0.99, 0.3])) * flip(&real(&[-1.01, 0.3])) < 0.0);
        let pair = |modulus: f64| {
            let mu = Complex::from_polar(modulus, 1.0);
            vec![mu, mu.conj(), Complex::new(0.1, 0.0)]
        };
        assert!(torus(&pair(0.99)) * torus(&pair(1.01)) < 0.0);
        assert!(fold(&pair(0.99)) * fold(&pair(1.01)) > 0.0);
    }

    #[test]
    fn zeros_and_giants_do_no_harm() {
        for values in [[0.5, 0.0, 0.0], [0.5, 1e200, 0.0], [0.5, -1e-200, 1e-300]] {
            for value in [fold, flip, torus].map(|test| test(&real(&values))) {
                assert!(value.is_finite() && value != 0.0, "{values:?}: {value}");
            }
        }
    }

    #[test]
    fn a_neutral_saddle_is_a_zero_of_the_torus() {
        let saddle = real(&[4.0, 0.25]);
        assert!(torus(&saddle).abs() < 1e-15);
    }
}
