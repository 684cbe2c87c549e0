//! Looking inside an accepted step, by the step map itself and not by its polynomial.

use super::super::collocation::Collocation;
use super::super::look::Look;
use super::stages::Trial;
use super::{Accepted, Radau, add};
use crate::field::{Field, Linear};
use crate::scalar::mapped;

impl<'f, F: Field<N>, const N: usize, const S: usize> Radau<'f, F, N, S> {
    /// The step map from the same start over the fraction `theta` of a solved step.
    pub(super) fn solve_within(
        &mut self,
        trial: &Trial<N, S>,
        collocation: &Collocation<N, S>,
        theta: f64,
    ) -> Option<Trial<N, S>> {
        let guess = mapped(&self.tableau.nodes, |node| collocation.at(theta * node));
        self.solve(theta * trial.step, guess)
    }

    /// State and field at the fraction `theta` of the last accepted step, by the step map itself.
    #[must_use]
    pub fn probe(
        &mut self,
        accepted: &Accepted<N, S>,
        theta: f64,
    ) -> Option<([f64; N], Linear<N>)> {
        let arrived = (self.state, self.start);
        (self.state, self.start) = (accepted.start, self.departure);
        let last = self.last;
        let trial = self
            .solve_within(&last, &accepted.collocation, theta)
            .filter(|trial| self.error(trial) <= 1.0);
        (self.state, self.start) = arrived;
        trial.map(|trial| (trial.end(), trial.arrival()))
    }

    /// The stages of the last accepted step, its beginning first: where the sign of a slope can be read off.
    pub(crate) fn looks(
        &self,
        accepted: &Accepted<N, S>,
    ) -> impl Iterator<Item = Look<N>> + use<'f, F, N, S> {
        let beginning = Look {
            theta: 0.0,
            state: accepted.start,
            linear: self.departure,
        };
        let (nodes, start) = (self.tableau.nodes, accepted.start);
        let (increments, linear) = (self.last.increments, self.last.linear);
        let stages = (0..S).map(move |i| Look {
            theta: nodes[i],
            state: add(&start, &increments[i]),
            linear: linear[i],
        });
        std::iter::once(beginning).chain(stages)
    }
}

impl<const N: usize, const S: usize> Accepted<N, S> {
    /// The state at the fraction `theta` of the step, on its polynomial.
    #[must_use]
    pub fn inside(&self, theta: f64) -> [f64; N] {
        add(&self.start, &self.collocation.at(theta))
    }
}
