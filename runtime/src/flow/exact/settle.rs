//! The mode of every contact at rest: which stick, which slide, and how those leave the surface.

use crate::field::exact::{ExactSystem, Mode, Modes};
use crate::flow::FlowError;
use crate::model::Model;
use crate::scalar::Inline;

/// Relative excess over its limit above which a force cannot hold, and distance below which it is at it.
pub(super) const EDGE: f64 = 1e-11;
/// Contacts among which all combinations are searched.
const SEARCHED: usize = 6;

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
    /// Order of the lowest derivative of w, or of the guard of a press, that does not vanish where it leaves; 0 if it does
    /// not.
    pub(super) departure: usize,
    /// Side of that guard; 0 for w and for the gap of a press.
    pub(super) side: f64,
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
    pub(super) fn settle(&mut self) -> Result<Verdict<M, N>, FlowError> {
        let orders = self.pass_idle()?;
        let mut verdict = self.settle_held()?;
        for (note, order) in verdict.notes.as_mut().iter_mut().zip(orders.as_ref()) {
            note.departure = note.departure.max(*order);
        }
        Ok(verdict)
    }

    /// The same where friction could hold every contact at rest.
    fn settle_held(&self) -> Result<Verdict<M, N>, FlowError> {
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

    pub(super) fn contacts(&self) -> impl Iterator<Item = usize> {
        (0..self.resting.as_ref().len()).filter(|&i| self.resting.as_ref()[i])
    }

    pub(super) fn all_stick(&self) -> Modes<M, N> {
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
        let limits = self.system.limits_under(&self.state, &snapshot.force);
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
}
