//! Friction forces at rest as a box-constrained problem: which contacts hold, and which are at their limit.

use crate::field::exact::solve;

/// Contacts up to which all combinations are tried.
const ENUMERATED: usize = 6;
const SWEEPS: usize = 20_000;
/// Relative distance from the limit at which an iterated force is at it.
const AT_LIMIT: f64 = 1e-9;

/// ẇ = rate + G λ, |λᵢ| ≤ limitᵢ.
pub(super) struct BoxProblem {
    /// G, row by row.
    pub(super) compliance: Vec<Vec<f64>>,
    pub(super) rate: Vec<f64>,
    pub(super) limit: Vec<f64>,
}

impl BoxProblem {
    /// Sign of each force that is at its limit, 0 for the others: unique if every principal minor of G is positive.
    pub(super) fn bound_signs(&self) -> Vec<f64> {
        if self.rate.len() <= ENUMERATED {
            self.enumerate()
        } else {
            self.iterate()
        }
    }

    /// What forces make of the rate of a contact.
    fn pushed(&self, contact: usize, force: impl Fn(usize) -> f64) -> f64 {
        let row = self.compliance[contact].iter().enumerate();
        let pushed: f64 = row.map(|(j, entry)| entry * force(j)).sum();
        self.rate[contact] + pushed
    }

    /// The combination of held, +limit and −limit that breaks its conditions least.
    fn enumerate(&self) -> Vec<f64> {
        let contacts = self.rate.len();
        let mut best = vec![0.0; contacts];
        let mut least = f64::INFINITY;
        for code in 0..3_u32.pow(contacts as u32) {
            let mut rest = code;
            let sign = |_| {
                let sign = [0.0, 1.0, -1.0][(rest % 3) as usize];
                rest /= 3;
                sign
            };
            let signs: Vec<f64> = (0..contacts).map(sign).collect();
            let violation = self.violation(&signs);
            if violation < least {
                (best, least) = (signs, violation);
            }
        }
        best
    }

    /// By how much held forces exceed their limits, or contacts at their limits do not give way to them.
    fn violation(&self, signs: &[f64]) -> f64 {
        let bound = |i: usize| signs[i] * self.limit[i];
        let contacts = 0..signs.len();
        let mut force: Vec<f64> = contacts.clone().map(|i| -self.pushed(i, bound)).collect();
        let free: Vec<bool> = signs.iter().map(|sign| *sign == 0.0).collect();
        let mut rows = self.compliance.clone();
        if solve(&mut rows, &mut force, &free).is_none() {
            return f64::INFINITY;
        }
        for i in contacts.clone().filter(|&i| !free[i]) {
            force[i] = bound(i);
        }
        let mut worst: f64 = 0.0;
        for i in contacts {
            let own = self.compliance[i][i];
            let excess = if free[i] {
                own * (force[i].abs() - self.limit[i])
            } else {
                signs[i] * self.pushed(i, |j| force[j])
            };
            worst = worst.max(excess / own);
        }
        worst
    }

    /// Projected Gauss-Seidel.
    fn iterate(&self) -> Vec<f64> {
        let mut force = vec![0.0; self.rate.len()];
        for _ in 0..SWEEPS {
            let mut change: f64 = 0.0;
            for i in 0..force.len() {
                let limit = self.limit[i];
                let step = -self.pushed(i, |j| force[j]) / self.compliance[i][i];
                let next = (force[i] + step).max(-limit).min(limit);
                change = change.max((next - force[i]).abs() / limit.max(f64::MIN_POSITIVE));
                force[i] = next;
            }
            if change < 1e-3 * AT_LIMIT {
                break;
            }
        }
        let sign = |(f, limit): (&f64, &f64)| {
            let bound = f.abs() >= limit * (1.0 - AT_LIMIT);
            if bound { f.signum() } else { 0.0 }
        };
        force.iter().zip(&self.limit).map(sign).collect()
    }
}

#[cfg(test)]
mod tests;
