//! Liouville: multipliers made to agree with the determinant of Φ, which a motion knows better than their product.

use nalgebra::Complex;

use super::exponents::exponents;
use crate::flow::Determinant;
use crate::motion::Factor;

/// A multiplier as Φ tells it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Told {
    /// Itself.
    pub(super) value: Complex<f64>,
    /// The logarithm of its modulus; `None` if Φ does not resolve it.
    pub(super) log: Option<f64>,
    /// How far an error of Φ moves its logarithm, over that error.
    pub(super) loose: f64,
}

impl Told {
    /// An exact zero.
    pub(super) const ZERO: Self = Self {
        value: Complex::new(0.0, 0.0),
        log: None,
        loose: 0.0,
    };

    fn stretch(&mut self, by: f64) {
        self.value *= by.exp();
        self.log = self.log.map(|log| log + by);
    }

    fn set(&mut self, log: f64, sign: f64) {
        let size = log.exp();
        let signed = if size > 0.0 { sign * size } else { 0.0 };
        self.value = Complex::new(signed, 0.0);
        self.log = Some(log);
    }

    /// The sign that it gives to a product of all; that of a complex pair is positive.
    fn sign(&self) -> f64 {
        if self.value.im == 0.0 {
            1.0_f64.copysign(self.value.re)
        } else {
            1.0
        }
    }
}

/// Makes the product of all, largest first, agree with the determinant. What Φ does not resolve takes all that lacks, with
/// several of them told apart by the `factors` of Φ; if it resolves all, each takes as much as its error is likely to be. The
/// least has the sign that the determinant needs.
pub(super) fn agree(all: &mut [Told], determinant: Determinant, factors: &[Factor]) {
    if let ([only], true) = (&mut *all, determinant.log.is_finite()) {
        only.set(determinant.log, determinant.sign);
        return;
    }
    let known: f64 = all.iter().filter_map(|one| one.log).sum();
    let rest = determinant.log - known;
    if !rest.is_finite() {
        return;
    }
    let live = all.iter().take_while(|one| one.log.is_some()).count();
    let (resolved, lost) = all.split_at_mut(live);
    match lost {
        [] => spread(resolved, rest),
        [last] => last.set(rest, 1.0),
        several => separate(several, rest, factors),
    }
    let sign = all.iter().map(Told::sign).product::<f64>();
    if let Some(last) = all.last_mut().filter(|last| last.value.im == 0.0) {
        last.value *= sign * determinant.sign;
    }
}

/// The change of all logarithms with this sum that is the least in units of their errors.
fn spread(all: &mut [Told], rest: f64) {
    let squares: f64 = all.iter().map(|one| one.loose.powi(2)).sum();
    if !(squares > 0.0 && squares.is_finite()) {
        return;
    }
    all.iter_mut()
        .for_each(|one| one.stretch(rest * one.loose.powi(2) / squares));
}

/// What Φ loses of several directions its factors keep; their sum is scaled to what is known of it.
fn separate(lost: &mut [Told], rest: f64, factors: &[Factor]) {
    let all = exponents(factors);
    let small = &all[all.len().saturating_sub(lost.len())..];
    let sum: f64 = small.iter().map(|(log, _)| log).sum();
    let mut shares = small.iter();
    for one in lost {
        match shares.next() {
            Some((log, sign)) => one.set(log * rest / sum, *sign),
            None => one.value = Complex::new(0.0, 0.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_known_worst_gives_way() {
        let told = |value: f64| Told {
            value: Complex::new(value, 0.0),
            log: Some(value.abs().ln()),
            loose: 1.0 / value.abs(),
        };
        let mut all = [told(-1e5), told(-3.4e-6 * 1.001)];
        agree(&mut all, Determinant::of(0.34), &[]);
        let product = all[0].value * all[1].value;
        assert!((product.re - 0.34).abs() < 1e-15 && product.im == 0.0);
        assert_eq!(all[0].value.re, -1e5);
        let mut lost = [
            told(-1e5),
            Told {
                log: None,
                ..told(1e-7)
            },
        ];
        agree(&mut lost, Determinant::of(0.34), &[]);
        assert!((lost[1].value.re + 3.4e-6).abs() < 1e-20, "its sign, too");
    }
}
