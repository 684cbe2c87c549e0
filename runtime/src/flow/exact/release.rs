//! Which contacts let go: those whose forces exceed their limits, one at a time where friction drops (3.4).

use super::box_qp::BoxProblem;
use super::settle::{EDGE, Rest, Verdict};
use crate::field::exact::{Mode, Snapshot};
use crate::flow::FlowError;
use crate::model::Model;

/// Relative difference of two utilisations that makes a tie.
const TIE: f64 = 1e-12;

impl<M: Model<N>, const N: usize> Rest<'_, M, N> {
    /// Lets one more contact go, or all that a box problem finds at limits that sliding does not lower.
    pub(super) fn release(
        &self,
        verdict: &mut Verdict<M, N>,
        tangential: &mut M::PerContact<bool>,
    ) -> Result<bool, FlowError> {
        if verdict.modes.sticking().next().is_none() {
            return Ok(false);
        }
        let snapshot = self.system.snapshot(&self.state, &verdict.modes)?;
        let force = |i: usize| snapshot.force.as_ref()[i];
        let stick = |i: usize| snapshot.stick.as_ref()[i];
        if verdict
            .modes
            .sticking()
            .any(|i| force(i).abs() > stick(i) * (1.0 + EDGE))
        {
            if verdict.modes.rests() {
                self.release_weakest(verdict, &snapshot);
            } else {
                self.release_overloaded(verdict, &snapshot.force);
            }
            return Ok(true);
        }
        let edge = |i: &usize| force(*i).abs() >= stick(*i) * (1.0 - EDGE);
        let edges: Vec<usize> = verdict.modes.sticking().filter(edge).collect();
        if edges.is_empty() {
            return Ok(false);
        }
        let moving = self.system.moving(&self.state, &verdict.modes)?;
        for i in edges {
            let way = force(i).signum();
            let rise = way * moving.force.as_ref()[i].eps - moving.stick.as_ref()[i].eps;
            if rise > 0.0 {
                verdict.modes.set(i, Mode::sliding(-way));
                tangential.as_mut()[i] = !self.weakens(i);
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Where reactions press, limits move with the forces, and it is no box problem: the most overloaded lets go.
    fn release_weakest(&self, verdict: &mut Verdict<M, N>, held: &Snapshot<M, f64, N>) {
        let (force, stick) = (held.force.as_ref(), held.stick.as_ref());
        let excess = |i: usize| force[i].abs() - stick[i] * (1.0 + EDGE);
        let over = verdict.modes.sticking().filter(|i| excess(*i) > 0.0);
        let share = |i: usize| force[i].abs() / stick[i];
        let weakest = over.reduce(|a, b| if share(b) > share(a) { b } else { a });
        if let Some(i) = weakest {
            verdict.modes.set(i, Mode::sliding(-force[i]));
        }
    }

    fn release_overloaded(&self, verdict: &mut Verdict<M, N>, held: &M::PerContact<f64>) {
        let affine = self.system.affine(&self.state, &verdict.modes);
        let modes = verdict.modes;
        let problem = BoxProblem::<M, N> {
            compliance: &affine.compliance,
            rate: &affine.rate,
            limit: &affine.stick,
            members: &|i| modes.as_slice()[i] == Mode::Stick,
        };
        let signs = problem.bound_signs();
        let limit = |i: usize| affine.stick.as_ref()[i];
        let use_of = |i: usize| held.as_ref()[i].abs() / limit(i);
        let bound = || modes.sticking().filter(|&i| signs.as_ref()[i] != 0.0);
        let first_of = |contacts: &mut dyn Iterator<Item = usize>| {
            contacts.reduce(|a, b| {
                if use_of(b) > use_of(a) * (1.0 + TIE) {
                    b
                } else {
                    a
                }
            })
        };
        if let Some(first) = first_of(&mut bound().filter(|&i| self.weakens(i))) {
            let tie = |i: usize| i != first && use_of(i) >= use_of(first) * (1.0 - TIE);
            verdict.notes.as_mut()[first].tied = bound().any(tie);
            verdict
                .modes
                .set(first, Mode::sliding(-signs.as_ref()[first]));
        } else if bound().next().is_some() {
            for i in bound() {
                verdict.modes.set(i, Mode::sliding(-signs.as_ref()[i]));
            }
        } else if let Some(first) = first_of(&mut modes.sticking()) {
            verdict
                .modes
                .set(first, Mode::sliding(-held.as_ref()[first]));
        }
    }

    /// Whether friction is let go together with a press, and is less from there on.
    pub(super) fn drops(&self, press: usize) -> bool {
        let goes = |i: &usize| self.let_go.as_ref()[*i] != 0.0 && self.system.is_tied(*i, press);
        self.contacts().filter(goes).any(|i| self.weakens(i))
    }

    /// Whether stick > slip(0⁺), so that a released contact does not leave tangentially.
    pub(super) fn weakens(&self, contact: usize) -> bool {
        let limits = self.system.limits_at_rest(&self.state);
        let (stick, slip) = limits.as_ref()[contact];
        stick - slip > EDGE * stick
    }
}
