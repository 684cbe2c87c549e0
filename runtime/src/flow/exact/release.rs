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
        let overload = Overload {
            stuck: verdict.modes.sticking().collect(),
            compliance: &|i, j| affine.compliance.as_ref()[i].as_ref()[j],
            rate: affine.rate.as_ref(),
            limit: affine.stick.as_ref(),
            held: held.as_ref(),
            weakens: &|contact| self.weakens(contact),
        };
        for freed in overload.freed() {
            verdict.modes.set(freed.contact, Mode::sliding(freed.way));
            verdict.notes.as_mut()[freed.contact].tied |= freed.tied;
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

/// Contacts that stick although not all of them can.
struct Overload<'a> {
    stuck: Vec<usize>,
    /// G.
    compliance: &'a dyn Fn(usize, usize) -> f64,
    /// Rate of each speed without sticking forces.
    rate: &'a [f64],
    limit: &'a [f64],
    /// The forces that would hold all.
    held: &'a [f64],
    /// Whether friction drops where a contact is let go.
    weakens: &'a dyn Fn(usize) -> bool,
}

/// A contact that is let go.
struct Freed {
    contact: usize,
    /// Sign of the speed with which it leaves.
    way: f64,
    /// Whether another one was as near to its limit.
    tied: bool,
}

impl Overload<'_> {
    /// Of those that are at their limits the nearest one where friction drops, otherwise all at once; the nearest of all if
    /// none is at its limit.
    fn freed(&self) -> Vec<Freed> {
        let free = |contact: usize, way: f64| Freed {
            contact,
            way,
            tied: false,
        };
        let use_of = |i: usize| self.held[i].abs() / self.limit[i];
        let signs = self.problem().bound_signs();
        let signed = self.stuck.iter().copied().zip(signs);
        let bound: Vec<(usize, f64)> = signed.filter(|(_, sign)| *sign != 0.0).collect();
        let mut dropping = bound.iter().map(|(i, _)| *i).filter(|&i| (self.weakens)(i));
        if let Some(first) = self.nearest(&mut dropping) {
            let tie = |i: usize| i != first && use_of(i) >= use_of(first) * (1.0 - TIE);
            let tied = bound.iter().any(|(i, _)| tie(*i));
            let own = bound.iter().filter(|(i, _)| *i == first);
            let let_go = own.map(|(i, sign)| Freed {
                tied,
                ..free(*i, -sign)
            });
            return let_go.collect();
        }
        if bound.is_empty() {
            let nearest = self.nearest(&mut self.stuck.iter().copied());
            return nearest
                .map(|i| free(i, -self.held[i]))
                .into_iter()
                .collect();
        }
        bound.into_iter().map(|(i, sign)| free(i, -sign)).collect()
    }

    fn problem(&self) -> BoxProblem {
        let row = |&i: &usize| {
            self.stuck
                .iter()
                .map(|&j| (self.compliance)(i, j))
                .collect()
        };
        let of = |all: &[f64]| self.stuck.iter().map(|&i| all[i]).collect();
        BoxProblem {
            compliance: self.stuck.iter().map(row).collect(),
            rate: of(self.rate),
            limit: of(self.limit),
        }
    }

    /// The first that is nearest to its limit.
    fn nearest(&self, contacts: &mut dyn Iterator<Item = usize>) -> Option<usize> {
        let use_of = |i: usize| self.held[i].abs() / self.limit[i];
        contacts.reduce(|a, b| {
            if use_of(b) > use_of(a) * (1.0 + TIE) {
                b
            } else {
                a
            }
        })
    }
}
