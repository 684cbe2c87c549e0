//! The mode of every contact at rest: which stick, which slide, and how those leave the surface (3.2 to 3.4).

use super::box_qp::BoxProblem;
use crate::field::exact::{ExactSystem, Mode, Modes};
use crate::flow::FlowError;
use crate::model::Model;
use crate::scalar::Inline;

/// Relative excess over its limit above which a force cannot hold, and distance below which it is at it.
pub(super) const EDGE: f64 = 1e-11;
/// Rate of a speed, relative to what friction can do, below which the next derivative decides.
const NO_RATE: f64 = 1e-12;
/// The same where the rate is known to vanish but for rounding errors.
const ROUNDED_RATE: f64 = 1e-9;
/// Contacts among which all combinations are searched.
const SEARCHED: usize = 6;
/// Relative difference of two utilisations that makes a tie.
const TIE: f64 = 1e-12;

/// What becomes of a contact that stops although it may also go on in the other direction.
///
/// Both are consistent where slip(0⁺) < |λ| ≤ stick: forward uniqueness is lost there.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Arrival {
    /// It sticks.
    #[default]
    Stick,
    /// It crosses.
    Cross,
}

/// Contacts without relative speed at one state, waiting for their modes.
pub(super) struct Rest<'s, M: Model<N>, const N: usize> {
    pub(super) system: &'s ExactSystem<M, N>,
    pub(super) arrival: Arrival,
    pub(super) state: [f64; N],
    pub(super) time: f64,
    /// Modes until now.
    pub(super) before: Modes<M, N>,
    /// Which contacts are at rest.
    pub(super) resting: M::PerContact<bool>,
    /// Sign of w with which a contact is let go because its guard fell; 0 for the others.
    pub(super) let_go: M::PerContact<f64>,
}

/// What was decided about one contact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Note {
    /// stick − |λ| if every contact at rest stuck.
    pub(super) margin: f64,
    /// Whether it could both stick and cross.
    pub(super) ambiguous: bool,
    /// Whether another contact was as near to its limit.
    pub(super) tied: bool,
    /// Order of the lowest derivative of w that does not vanish where it leaves; 0 if it does not.
    pub(super) departure: usize,
}

/// The modes with which a motion goes on.
pub(super) struct Verdict<M: Model<N>, const N: usize> {
    pub(super) modes: Modes<M, N>,
    pub(super) notes: M::PerContact<Note>,
}

impl<M: Model<N>, const N: usize> Rest<'_, M, N> {
    /// Decides.
    ///
    /// # Errors
    /// Forces that are not unique, or a contact that would not leave the way it is let go.
    pub(super) fn settle(&self) -> Result<Verdict<M, N>, FlowError> {
        let mut verdict = Verdict {
            modes: self.all_stick(),
            notes: Inline::from_fn(|_| Note::default()),
        };
        self.note_arrivals(&mut verdict)?;
        let mut tangential = self.let_go_first(&mut verdict);
        // Every round lets at least one contact go, so that there are at most as many as contacts.
        while self.release(&mut verdict, &mut tangential)? {}
        let judged = self.judge_departures(&mut verdict, &tangential);
        match judged {
            Err(FlowError::InconsistentMode { .. }) => match self.search(&tangential)? {
                Some(found) => Ok(found),
                None => judged.map(|()| verdict),
            },
            _ => judged.map(|()| verdict),
        }
    }

    /// Among all combinations of modes those that hold together, and of these the first that sticks most.
    ///
    /// Letting go one by one may overshoot where contacts act on each other: a force that drops can
    /// turn the way in which another was let go. Some combination always holds, since limits lowered
    /// to slip(0⁺) everywhere make it a convex problem.
    fn search(&self, tangential: &M::PerContact<bool>) -> Result<Option<Verdict<M, N>>, FlowError> {
        const CHOICES: [Mode; 3] = [Mode::Stick, Mode::SlideForward, Mode::SlideBackward];
        let mut best: Option<Verdict<M, N>> = None;
        let count = self.contacts().count().min(SEARCHED) as u32;
        for code in 0..3_u32.pow(count) {
            let mut verdict = Verdict {
                modes: self.all_stick(),
                notes: Inline::from_fn(|_| Note::default()),
            };
            self.note_arrivals(&mut verdict)?;
            let mut rest = code;
            for i in self.contacts().take(SEARCHED) {
                verdict.modes.set(i, CHOICES[(rest % 3) as usize]);
                rest /= 3;
            }
            let sticking = |v: &Verdict<M, N>| v.modes.sticking().count();
            if best
                .as_ref()
                .is_some_and(|b| sticking(b) >= sticking(&verdict))
            {
                continue;
            }
            let modes = verdict.modes;
            let holds = !self.release(&mut verdict, &mut { *tangential })?;
            if holds
                && modes == verdict.modes
                && self.judge_departures(&mut verdict, tangential).is_ok()
            {
                best = Some(verdict);
            }
        }
        Ok(best)
    }

    fn contacts(&self) -> impl Iterator<Item = usize> {
        (0..self.resting.as_ref().len()).filter(|&i| self.resting.as_ref()[i])
    }

    fn all_stick(&self) -> Modes<M, N> {
        let before = self.before.as_slice();
        Modes::from_fn(|i| {
            if self.resting.as_ref()[i] {
                Mode::Stick
            } else {
                before[i]
            }
        })
    }

    /// Notes how firmly each contact would be held, and lets arrivals cross where that is the rule.
    fn note_arrivals(&self, verdict: &mut Verdict<M, N>) -> Result<(), FlowError> {
        if self.contacts().next().is_none() {
            return Ok(());
        }
        let snapshot = self.system.snapshot(&self.state, &verdict.modes)?;
        let limits = self.system.limits_at_rest(&self.state);
        for i in self.contacts() {
            let came = self.before.as_slice()[i].sign();
            let (force, stick) = (snapshot.force.as_ref()[i], snapshot.stick.as_ref()[i]);
            let note = &mut verdict.notes.as_mut()[i];
            note.margin = stick - force.abs();
            let held = came * force <= stick * (1.0 + EDGE);
            note.ambiguous =
                came != 0.0 && held && came * force > limits.as_ref()[i].1 * (1.0 + EDGE);
            if note.ambiguous && self.arrival == Arrival::Cross {
                verdict.modes.set(i, Mode::sliding(-came));
            }
        }
        Ok(())
    }

    /// Lets those go whose guard fell; true where w and ẇ vanish together.
    fn let_go_first(&self, verdict: &mut Verdict<M, N>) -> M::PerContact<bool> {
        let mut tangential: M::PerContact<bool> = Inline::from_fn(|_| false);
        for i in self.contacts() {
            let way = self.let_go.as_ref()[i];
            if way != 0.0 {
                verdict.modes.set(i, Mode::sliding(way));
                tangential.as_mut()[i] = !self.weakens(i);
            }
        }
        tangential
    }

    /// Whether stick > slip(0⁺), so that a released contact does not leave tangentially.
    fn weakens(&self, contact: usize) -> bool {
        let limits = self.system.limits_at_rest(&self.state);
        let (stick, slip) = limits.as_ref()[contact];
        stick - slip > EDGE * stick
    }

    /// Lets one more contact go, or all that a box problem finds at limits that sliding does not lower.
    fn release(
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
            self.release_overloaded(verdict, &snapshot.force);
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

    /// The first derivative of w that does not vanish must have the sign of the new mode (3.3).
    fn judge_departures(
        &self,
        verdict: &mut Verdict<M, N>,
        tangential: &M::PerContact<bool>,
    ) -> Result<(), FlowError> {
        let slides = |i: &usize| verdict.modes.as_slice()[*i] != Mode::Stick;
        let leaving: Vec<usize> = self.contacts().filter(slides).collect();
        if leaving.is_empty() {
            return Ok(());
        }
        let moving = self.system.moving(&self.state, &verdict.modes)?;
        let second = self
            .system
            .second_rates(&self.state, &verdict.modes, &moving.field);
        let able = self.system.affine(&self.state, &self.all_stick());
        for contact in leaving {
            let mode = verdict.modes.as_slice()[contact];
            let compliance = able.compliance.as_ref()[contact].as_ref()[contact];
            let scale = compliance
                * (able.stick.as_ref()[contact] + verdict.notes.as_ref()[contact].margin.abs());
            let rate = moving.speed.as_ref()[contact].eps;
            let second_rate = second.as_ref()[contact];
            let threshold = if tangential.as_ref()[contact] {
                ROUNDED_RATE
            } else {
                NO_RATE
            };
            let flat = rate.abs() <= threshold * scale;
            let (order, decisive) = if flat { (2, second_rate) } else { (1, rate) };
            if mode.sign() * decisive <= 0.0 || !decisive.is_finite() {
                return Err(FlowError::InconsistentMode {
                    contact,
                    time: self.time,
                    mode,
                    speed: moving.speed.as_ref()[contact].re,
                    rate,
                    second_rate,
                });
            }
            verdict.notes.as_mut()[contact].departure = order;
        }
        Ok(())
    }
}
