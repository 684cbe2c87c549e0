//! What the rate of a gap, and the reaction that keeps it closed, are measured against.

use crate::field::exact::{ExactSystem, Modes};
use crate::model::Model;
use crate::scalar::Lanes;

impl<M: Model<N>, const N: usize> ExactSystem<M, N> {
    /// The magnitude of the terms of the rate of a gap.
    pub(super) fn rate_terms(&self, state: &[f64; N], press: usize) -> f64 {
        let alone = Modes::resting_alone(press);
        let rate = self.linear_rates(state, &alone).as_ref()[press];
        let (slopes, _): ([f64; N], f64) = rate.slopes();
        let terms = || slopes.iter().zip(state).map(|(slope, y)| slope * y);
        let value = self.rates(state, &alone).as_ref()[press];
        let rest = value - terms().sum::<f64>();
        terms().map(f64::abs).sum::<f64>() + rest.abs()
    }

    /// The magnitude of the terms of the rate of a gap, or the usual one: against fixed ground a rate is its own only term,
    /// and only what is usual tells rounding errors.
    pub(super) fn rate_scale(&self, state: &[f64; N], press: usize) -> f64 {
        let usual = self.usual_rate(state, press);
        self.rate_terms(state, press).max(usual)
    }

    /// Usual magnitude of the rate of a gap, as far as that of the states tells.
    fn usual_rate(&self, state: &[f64; N], press: usize) -> f64 {
        let rate = self
            .linear_rates(state, &Modes::resting_alone(press))
            .as_ref()[press];
        let (slopes, _): ([f64; N], f64) = rate.slopes();
        let terms = slopes.iter().zip(&self.magnitude);
        terms.map(|(slope, usual)| (slope * usual).abs()).sum()
    }

    /// The magnitude of the terms of a reaction: of what it keeps from happening to the rate of its gap.
    pub(super) fn terms_of_reaction(
        &self,
        state: &[f64; N],
        modes: &Modes<M, N>,
        press: usize,
    ) -> f64 {
        let affine = self.affine(state, modes);
        let (slopes, _): ([f64; N], f64) = self.linear_rates(state, modes).as_ref()[press].slopes();
        let terms = slopes.iter().zip(&affine.field);
        let sum: f64 = terms.map(|(slope, f)| (slope * f).abs()).sum();
        let own = sum / affine.compliance.as_ref()[press].as_ref()[press].abs();
        let tied = (0..M::INFO.contacts.len()).filter(|&i| self.is_tied(i, press));
        let shared = tied.map(|i| affine.stick.as_ref()[i] * self.factor(state, i, press).abs());
        own + shared.sum::<f64>()
    }
}
