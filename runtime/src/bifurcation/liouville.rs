//! Liouville: multipliers made to agree with the determinant of Φ, which a motion knows better than their product.

use nalgebra::Complex;

use super::growth::Growth;
use crate::flow::Determinant;

/// A multiplier as Φ tells it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Told {
    /// Itself.
    pub(super) value: Complex<f64>,
    /// The logarithm of its modulus; `None` if Φ does not resolve it.
    pub(super) log: Option<f64>,
    /// How far an error of Φ moves its logarithm, over that error.
    pub(super) loose: f64,
    /// What it may be off by.
    pub(super) error: f64,
}

impl Told {
    /// An exact zero.
    pub(super) const ZERO: Self = Self {
        value: Complex::new(0.0, 0.0),
        log: None,
        loose: 0.0,
        error: 0.0,
    };

    /// ln μ, real where the multiplier is, whatever its sign; its error is to the rate as that of μ to its way to the circle.
    /// Where nothing is known but that it is no larger than its error, that is all that is told.
    pub(super) fn growth(&self) -> Growth {
        let (size, real) = (self.value.norm(), self.value.im == 0.0);
        let turn = if real { 0.0 } else { self.value.arg() };
        let (rate, way) = (size.ln(), size - 1.0);
        if self.log.is_none() && self.error >= 1.0 {
            let most = (size + self.error).ln();
            return Growth::new(Complex::new(rate.clamp(-most, most), turn), most);
        }
        let slope = if way == 0.0 { 1.0 } else { rate / way };
        let error = if size > 0.0 { self.error * slope } else { 0.0 };
        Growth::new(Complex::new(rate, turn), error)
    }

    fn stretch(&mut self, by: f64) {
        self.value *= by.exp();
        self.log = self.log.map(|log| log + by);
    }

    /// Takes this logarithm, which may be off by as much, and is no larger than Φ said.
    fn set(&mut self, log: f64, sign: f64, off: f64) {
        let size = log.exp();
        let most = self.value.norm() + self.error;
        let signed = if size > 0.0 { sign * size } else { 0.0 };
        self.value = Complex::new(signed, 0.0);
        self.log = Some(log);
        self.error = (size * off).min(size + most);
    }

    /// What its logarithm may be off by.
    fn off(&self) -> f64 {
        self.error / self.value.norm()
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

/// Makes the product of all, largest first, agree with the determinant, which is known with a relative error. What Φ does not
/// resolve takes all that lacks, with several of them told apart by their `exponents` and signs; if it resolves all, each
/// takes as much as its error is likely to be, and what is left of that is no more than what is known of all others. The least
/// has the sign that the determinant needs.
pub(super) fn agree(
    all: &mut [Told],
    (determinant, error): (Determinant, f64),
    exponents: impl FnOnce() -> Vec<(f64, f64)>,
) {
    if !determinant.log.is_finite() {
        return;
    }
    let error = error * determinant.log.abs().max(1.0);
    if let [only] = &mut *all {
        only.set(determinant.log, determinant.sign, error);
        return;
    }
    let known: f64 = all.iter().filter_map(|one| one.log).sum();
    let rest = determinant.log - known;
    if !rest.is_finite() {
        return;
    }
    let live = all.iter().take_while(|one| one.log.is_some()).count();
    let (resolved, lost) = all.split_at_mut(live);
    let off = error + resolved.iter().map(Told::off).sum::<f64>();
    match lost {
        [] => spread(resolved, (rest, error)),
        [last] => last.set(rest, 1.0, off),
        several => separate(several, (rest, off), &exponents()),
    }
    let sign = all.iter().map(Told::sign).product::<f64>();
    if let Some(last) = all.last_mut().filter(|last| last.value.im == 0.0) {
        last.value *= sign * determinant.sign;
    }
}

/// The change of all logarithms with this sum that is the least in units of their errors. Each is known no worse than all
/// others and the sum, which has this error.
fn spread(all: &mut [Told], (rest, error): (f64, f64)) {
    let squares: f64 = all.iter().map(|one| one.loose.powi(2)).sum();
    if !(squares > 0.0 && squares.is_finite()) {
        return;
    }
    let offs: Vec<f64> = all.iter().map(Told::off).collect();
    for (i, one) in all.iter_mut().enumerate() {
        let others = offs.iter().enumerate().filter(|(j, _)| *j != i);
        let others: f64 = others.map(|(_, off)| off).sum();
        one.stretch(rest * one.loose.powi(2) / squares);
        one.error = one.error.min((error + others) * one.value.norm());
    }
}

/// What Φ loses of several directions is told by their exponents, the least of all; their sum is scaled to what is known of it.
/// Without these, directions that Φ says to be within the circle have underflowed.
fn separate(lost: &mut [Told], (rest, off): (f64, f64), exponents: &[(f64, f64)]) {
    let small = &exponents[exponents.len().saturating_sub(lost.len())..];
    let sum: f64 = small.iter().map(|(log, _)| log).sum();
    let mut shares = small.iter();
    for one in lost {
        match shares.next() {
            Some((log, sign)) => {
                let change = log * (rest / sum - 1.0);
                one.set(log + change, *sign, off + change.abs());
            }
            None if one.error < 1.0 => one.value = Complex::new(0.0, 0.0),
            None => {}
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
            error: 1e-6,
        };
        let mut all = [told(-1e5), told(-3.4e-6 * 1.001)];
        agree(&mut all, (Determinant::of(0.34), 0.0), Vec::new);
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
        agree(&mut lost, (Determinant::of(0.34), 0.0), Vec::new);
        assert!((lost[1].value.re + 3.4e-6).abs() < 1e-20, "its sign, too");
        for all in [all, lost] {
            assert!((all[1].off() / 1e-11 - 1.0).abs() < 1e-9, "as the other");
        }
    }

    #[test]
    fn what_nothing_tells_is_no_zero() {
        let lost = Told {
            value: Complex::new(1e3, 0.0),
            log: None,
            loose: 1.0,
            error: 1e4,
        };
        let mut all = [lost; 2];
        agree(&mut all, (Determinant::grown(-1e4), 0.0), Vec::new);
        assert!(all.iter().all(|one| one.growth().is_marginal()), "{all:?}");
        let mut all = [lost; 2];
        agree(&mut all, (Determinant::grown(-99.0), 0.0), || {
            vec![(1.0, -1.0), (-100.0, 1.0)]
        });
        assert_eq!([all[0].log, all[1].log], [Some(1.0), Some(-100.0)]);
        assert!(all[0].growth().rate > all[0].growth().error);
    }
}
