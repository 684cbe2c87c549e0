//! What happens at an event: which contacts switch, and into which modes.

use super::guard::{Departure, Guard, Sighting};
use super::press::{Presses, Vanishing};
use super::run::Run;
use super::settle::{EDGE, Rest, Verdict};
use super::steps::Steps;
use crate::field::exact::{Mode, Modes};
use crate::flow::{Event, EventKind, FlowError};
use crate::model::Model;
use crate::scalar::Inline;

/// Value of a guard, relative to its scale, up to which it has fallen where it was to fall.
const FALLEN: f64 = 1e-12;
/// Depth to which a guard falls, in units of what is tolerated, up to which it only grazes.
const GRAZE: f64 = 1.0;
/// Rounding error of a guard, relative to its scale.
pub(super) const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The guards that fell at one instant.
pub(super) struct Strike<M: Model<N>, const N: usize> {
    pub(super) fallen: M::PerContact<Option<Guard>>,
    /// Rates at which they fell, along the motion.
    rates: M::PerContact<f64>,
    /// Magnitudes of their terms.
    scales: M::PerContact<f64>,
    first: usize,
    /// Whether the tolerance does not tell the event from a miss.
    pub(super) grazes: bool,
}

impl<M: Model<N>, const N: usize> Strike<M, N> {
    /// How far the guard that fell may be off by the rounding of its terms.
    pub(super) fn rounding(&self, contact: usize) -> f64 {
        f64::EPSILON * self.scales.as_ref()[contact]
    }
}

impl<'f, M: Model<N>, const N: usize> Run<'f, M, N> {
    /// The guards that vanish at the end of a shortened step; `None` if even the awaited one does not,
    /// because the step map only comes near the surface that the dense output crossed.
    pub(super) fn struck(
        &self,
        stepper: &Steps<'_, 'f, M, N>,
        awaited: &Sighting,
    ) -> Result<Option<Strike<M, N>>, FlowError> {
        let state = stepper.end();
        let system = &self.flow.system;
        let at = system.moving(state, &self.modes)?;
        let scales = self.flow.speed_scales(state);
        let began = system.speeds(stepper.from());
        // Where no state can be told from where the step began, a guard is as near to zero as it comes.
        let resolved = state != stepper.from();
        let mut fallen: M::PerContact<Option<Guard>> = Inline::from_fn(|_| None);
        let mut rates: M::PerContact<f64> = Inline::from_fn(|_| 0.0);
        let mut terms = rates;
        let mut grazes = false;
        let modes = self.modes.as_slice().iter().enumerate();
        for (i, mode) in modes.filter(|(i, _)| !system.is_idle(*i)) {
            for guard in Guard::of(i, *mode) {
                let value = guard.value(&self.modes, &at);
                let scale = if mode.is_of_press() && guard.side != 0.0 {
                    self.flow.hold_scale(state, &self.modes, i)?
                } else if guard.side == 0.0 {
                    // Against fixed ground w is its only term: what it has lost in the step is what was rounded.
                    // Where a gap is all but touched, its rate does not tell that.
                    let fell = if mode.is_of_press() {
                        began.as_ref()[i].abs()
                    } else {
                        0.0
                    };
                    let lost = stepper.length() * value.eps.abs();
                    scales.as_ref()[i].max(lost).max(fell)
                } else {
                    at.stick.as_ref()[i].re + at.force.as_ref()[i].re.abs()
                };
                let tolerated = self.flow.settings.tolerance.of(scale);
                // What is least just here, as a reaction at the top of a cam, falls at the rate of its rounding error.
                let noise = match mode.is_of_press() && guard.side != 0.0 {
                    true => ROUNDING * scale / stepper.length(),
                    false => 0.0,
                };
                let at_once = value.eps < -noise && value.re <= tolerated;
                let was_awaited = guard == awaited.guard;
                // Next to where a gap opens or friction turns beside it, rounding alone falls: nothing hits that goes away. What
                // closes without any time would do so for ever.
                let opens = *mode == Mode::Open && value.eps > 0.0 && stepper.length() > 0.0;
                let missed = resolved && value.re > FALLEN * scale;
                if was_awaited && (opens || missed) {
                    return Ok(None);
                }
                if was_awaited {
                    grazes = awaited.depth <= GRAZE * tolerated;
                }
                // Where a gap opens, what held it closed may fall with it.
                let opens = mode.is_of_press() && fallen.as_ref()[i].is_some();
                if (was_awaited || at_once) && !opens {
                    fallen.as_mut()[i] = Some(guard);
                    (rates.as_mut()[i], terms.as_mut()[i]) = (value.eps, scale);
                }
            }
        }
        let first = awaited.guard.contact;
        Ok(Some(Strike {
            fallen,
            rates,
            scales: terms,
            first,
            grazes,
        }))
    }

    /// Passes to the modes after an event.
    pub(super) fn switch(&mut self, strike: &Strike<M, N>) -> Result<(), FlowError> {
        if const { Modes::<M, N>::PRESSED } {
            if let Some(press) = self.hit(strike)? {
                return self.bounce(press, strike);
            }
        }
        let fallen = strike.fallen.as_ref();
        let presses = self.switched_presses(strike)?;
        let state = *self.carried.state();
        let rest = |before: Modes<M, N>| Rest {
            system: &self.flow.system,
            arrival: self.flow.arrival,
            state,
            time: self.time,
            before,
            resting: Inline::from_fn(|i| {
                let (mode, lands) = (before.as_slice()[i], self.lands(i, &before));
                let still = fallen[i].is_some() || lands || self.unpinned(i, &before).is_some();
                mode == Mode::Stick || (mode.rubs() && still)
            }),
            let_go: Inline::from_fn(|i| match self.unpinned(i, &before) {
                Some(mode) => mode.sign(),
                None => fallen[i].map_or(0.0, |guard| -guard.side),
            }),
        };
        let verdict = self.flow.borne(&state, self.time, &presses, &rest)?;
        self.pass_derivatives(strike, &verdict.modes)?;
        self.close_segment();
        let before = self.modes;
        self.take(&verdict, &strike.rates)?;
        self.note_nearest_here(&before)?;
        self.count_chatter(strike.first)
    }

    /// The way in which a contact goes on whose press has let go.
    fn unpinned(&self, contact: usize, now: &Modes<M, N>) -> Option<Mode> {
        let slides = self.modes.as_slice()[contact].unpinned();
        slides.filter(|_| now.as_slice()[contact].rubs())
    }

    /// Whether a contact that was loose has no relative speed where it is pressed again.
    fn lands(&self, contact: usize, pressed: &Modes<M, N>) -> bool {
        let state = self.carried.state();
        self.modes.as_slice()[contact] == Mode::Loose
            && pressed.as_slice()[contact].rubs()
            && self.flow.system.speeds(state).as_ref()[contact].abs()
                <= ROUNDING * self.flow.speed_scales(state).as_ref()[contact]
    }

    /// The modes after the guards of presses have fallen, other contacts as they are or no longer loose.
    fn switched_presses(&self, strike: &Strike<M, N>) -> Result<Presses<M, N>, FlowError> {
        let vanishing = |press: usize| {
            let guard = strike.fallen.as_ref()[press]?;
            Some(if guard.side == 0.0 {
                Vanishing::Gap
            } else {
                Vanishing::Hold
            })
        };
        let state = self.carried.state();
        self.flow.with_presses(state, self.modes, &vanishing)
    }

    /// Takes the modes that were decided after guards fell at these rates, and notes what changed.
    pub(super) fn take(
        &mut self,
        verdict: &Verdict<M, N>,
        rates: &M::PerContact<f64>,
    ) -> Result<(), FlowError> {
        let before = self.modes;
        let hit = self.events.last().filter(|last| {
            let impact = matches!(
                last.kind,
                EventKind::Impact { .. } | EventKind::Settled { .. }
            );
            impact && last.time == self.time
        });
        let hit = hit.map(|last| last.contact);
        let pairs = before.as_slice().iter().zip(verdict.modes.as_slice());
        for (contact, (old, new)) in pairs.enumerate().filter(|(_, (old, new))| old != new) {
            let note = verdict.notes.as_ref()[contact];
            let (margin, ambiguous) = (note.margin, note.ambiguous);
            let kind = match (old, new) {
                (Mode::Parted, Mode::Open) | (_, Mode::Loose) => continue,
                (Mode::Loose, Mode::SlideForward | Mode::SlideBackward) => continue,
                (_, Mode::Rest) if hit == Some(contact) => continue,
                (_, Mode::Closed | Mode::Rest) => EventKind::Closing,
                (_, Mode::Open | Mode::Parted) => EventKind::Opening,
                (Mode::PinnedForward | Mode::PinnedBackward, Mode::Stick) => continue,
                (_, Mode::Stick | Mode::PinnedForward | Mode::PinnedBackward) => {
                    EventKind::Landing { margin, ambiguous }
                }
                (Mode::Stick | Mode::PinnedForward | Mode::PinnedBackward, _) => {
                    EventKind::Release { tied: note.tied }
                }
                _ => EventKind::Crossing {
                    margin: -margin,
                    ambiguous,
                },
            };
            self.work.events += 1;
            self.events.push(Event {
                kind,
                contact,
                mode: *new,
                time: self.time,
                state: *self.carried.state(),
                rate: rates.as_ref()[contact],
            });
        }
        self.modes = verdict.modes;
        self.put_on_surface()?;
        self.note_departures(verdict)
    }

    /// Notes which guards vanish where the motion goes on, to be deflated in the first step.
    fn note_departures(&mut self, verdict: &Verdict<M, N>) -> Result<(), FlowError> {
        let order = |i: usize| verdict.notes.as_ref()[i].departure;
        self.departure = Inline::from_fn(|i| Departure {
            side: verdict.notes.as_ref()[i].side,
            order: order(i),
        });
        if self.modes.sticking().next().is_none() {
            return Ok(());
        }
        let at = self
            .flow
            .system
            .snapshot(self.carried.state(), &self.modes)?;
        for i in self.modes.sticking() {
            let (force, stick) = (at.force.as_ref()[i], at.stick.as_ref()[i]);
            if force.abs() >= stick * (1.0 - EDGE) {
                self.departure.as_mut()[i] = Departure {
                    side: force.signum(),
                    order: 1,
                };
            }
        }
        Ok(())
    }
}
