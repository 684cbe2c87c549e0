//! Friction forces at rest as a box-constrained problem: which contacts hold, and which are at their limit.

use crate::field::exact::{Square, solve};
use crate::model::Model;
use crate::scalar::Inline;

/// Contacts up to which all combinations are tried.
const ENUMERATED: usize = 6;
const SWEEPS: usize = 20_000;
/// Relative distance from the limit at which an iterated force is at it.
const AT_LIMIT: f64 = 1e-9;

/// ẇ = rate + G λ for `members`, |λᵢ| ≤ limitᵢ.
pub(super) struct BoxProblem<'a, M: Model<N>, const N: usize> {
    pub(super) compliance: &'a Square<M, f64, N>,
    pub(super) rate: &'a M::PerContact<f64>,
    pub(super) limit: &'a M::PerContact<f64>,
    pub(super) members: &'a dyn Fn(usize) -> bool,
}

impl<M: Model<N>, const N: usize> BoxProblem<'_, M, N> {
    /// Sign of each force that is at its limit, 0 for the others: unique if every principal minor of G is positive.
    pub(super) fn bound_signs(&self) -> M::PerContact<f64> {
        if self.numbers().count() <= ENUMERATED {
            self.enumerate()
        } else {
            self.iterate()
        }
    }

    fn numbers(&self) -> impl Iterator<Item = usize> {
        (0..self.rate.as_ref().len()).filter(|&i| (self.members)(i))
    }

    fn entry(&self, i: usize, j: usize) -> f64 {
        self.compliance.as_ref()[i].as_ref()[j]
    }

    /// The combination of held, +limit and −limit that breaks its conditions least.
    fn enumerate(&self) -> M::PerContact<f64> {
        let mut best: M::PerContact<f64> = Inline::from_fn(|_| 0.0);
        let mut least = f64::INFINITY;
        for code in 0..3_u32.pow(self.numbers().count() as u32) {
            let mut signs: M::PerContact<f64> = Inline::from_fn(|_| 0.0);
            let mut rest = code;
            for i in self.numbers() {
                signs.as_mut()[i] = [0.0, 1.0, -1.0][(rest % 3) as usize];
                rest /= 3;
            }
            let violation = self.violation(&signs);
            if violation < least {
                (best, least) = (signs, violation);
            }
        }
        best
    }

    /// By how much held forces exceed their limits, or contacts at their limits do not give way to them.
    fn violation(&self, signs: &M::PerContact<f64>) -> f64 {
        let sign = |i: usize| signs.as_ref()[i];
        let limit = |i: usize| self.limit.as_ref()[i];
        let free = |i: usize| (self.members)(i) && sign(i) == 0.0;
        let rhs: M::PerContact<f64> = Inline::from_fn(|i| {
            let bound = self.numbers().filter(|&j| sign(j) != 0.0);
            let pushed: f64 = bound.map(|j| self.entry(i, j) * sign(j) * limit(j)).sum();
            -(self.rate.as_ref()[i] + pushed)
        });
        let Some(held) = solve::<M, f64, N>(*self.compliance, rhs, free) else {
            return f64::INFINITY;
        };
        let force = |i: usize| {
            if free(i) {
                held.as_ref()[i]
            } else {
                sign(i) * limit(i)
            }
        };
        let mut worst: f64 = 0.0;
        for i in self.numbers() {
            let pushed: f64 = self.numbers().map(|j| self.entry(i, j) * force(j)).sum();
            let excess = if free(i) {
                self.entry(i, i) * (force(i).abs() - limit(i))
            } else {
                sign(i) * (self.rate.as_ref()[i] + pushed)
            };
            worst = worst.max(excess / self.entry(i, i));
        }
        worst
    }

    /// Projected Gauss-Seidel.
    fn iterate(&self) -> M::PerContact<f64> {
        let mut force: M::PerContact<f64> = Inline::from_fn(|_| 0.0);
        for _ in 0..SWEEPS {
            let mut change: f64 = 0.0;
            for i in self.numbers() {
                let limit = self.limit.as_ref()[i];
                let pushed: f64 = self
                    .numbers()
                    .map(|j| self.entry(i, j) * force.as_ref()[j])
                    .sum();
                let step = -(self.rate.as_ref()[i] + pushed) / self.entry(i, i);
                let next = (force.as_ref()[i] + step).max(-limit).min(limit);
                change =
                    change.max((next - force.as_ref()[i]).abs() / limit.max(f64::MIN_POSITIVE));
                force.as_mut()[i] = next;
            }
            if change < 1e-3 * AT_LIMIT {
                break;
            }
        }
        Inline::from_fn(|i| {
            let (f, limit) = (force.as_ref()[i], self.limit.as_ref()[i]);
            let bound = (self.members)(i) && f.abs() >= limit * (1.0 - AT_LIMIT);
            if bound { f.signum() } else { 0.0 }
        })
    }
}

#[cfg(test)]
mod tests;
