//! Events that follow each other ever faster: how they come to their end, and when an exact motion is given up.

use num_dual::Dual64;

use super::bounce::Rebound;
use super::press::Vanishing;
use super::run::{NO_TIME, Run};
use crate::field::exact::{Mode, Modes, Snapshot};
use crate::flow::FlowError;
use crate::flow::saltation::product;
use crate::integrate::IntegrationError;
use crate::model::Model;

/// Events that may follow each other within [`NO_TIME`] of the passage.
const CHATTER: u64 = 100;
/// Height of a bounce, in units of the terms of its gap, from which on a chatter is taken to its end at once.
const LOW: f64 = 1e-10;
/// The same where friction under it may turn meanwhile: little above what rounding leaves of a gap.
pub(super) const LOWEST: f64 = 1e-14;

/// How a press flies that an impact makes leave.
pub(super) struct Flight {
    departure: f64,
    /// Magnitude of the terms of its gap.
    scale: f64,
}

impl Flight {
    /// Whether it comes back, pulled so much, from no more than this part of the terms of its gap: v²/2a.
    pub(super) fn stays_below(&self, low: f64, pull: f64) -> bool {
        let Self { departure, scale } = self;
        pull > 0.0 && departure * departure <= 2.0 * low * scale * pull
    }
}

impl<M: Model<N>, const N: usize> Run<'_, M, N> {
    /// The flight that begins at this speed at a state.
    pub(super) fn flight(&self, press: usize, state: &[f64; N], departure: f64) -> Flight {
        let terms = self.flow.speed_scales(state).as_ref()[press];
        Flight {
            departure,
            scale: terms.max(self.flow.system.usual_speed(press)),
        }
    }

    /// Counts events that follow each other in no time.
    pub(super) fn count_chatter(&mut self, contact: usize) -> Result<(), FlowError> {
        let (events, since) = &mut self.chatter;
        if self.time - *since > NO_TIME * self.span {
            (*events, *since) = (0, self.time);
        }
        *events += 1;
        if *events > CHATTER {
            return Err(FlowError::Chattering {
                contact: M::INFO.contact_id(contact),
                time: self.time,
                events: *events,
            });
        }
        Ok(())
    }

    /// The end of a chatter, where an impact is so slow that all that follow are as good as one that leaves the gap closed:
    /// they take the motion elsewhere by the third power of its speed only. Where friction under it may turn or stick between
    /// them, by its speed itself: then they are followed for longer.
    ///
    /// Departures fall by the same ratio each time, so that flights of the duration 2v/a add up to 2v/(a (1 − ratio)); the
    /// reaction must not end before. Until then the motion is that of the closed gap, to which each bounce comes back.
    /// Friction along the way of the press pulls back on the way out and holds up on the way in: with b for a there, s² = b/a
    /// times the height is lost, and flights of the duration v/a + s v/b add up to as much divided by 1 − s ratio.
    pub(super) fn settling(
        &self,
        press: usize,
        state: &[f64; N],
    ) -> Result<Option<Rebound<M, N>>, FlowError> {
        let flow = self.flow;
        let (approach, departure) = flow.system.approach(state, press);
        let back = -self.bend(press, state, self.modes)?;
        let leaving = self.leaving(press, state);
        let kept = if leaving == self.modes {
            1.0
        } else {
            (back / -self.bend(press, state, leaving)?).sqrt()
        };
        let ratio = kept * departure / approach;
        let falls = approach <= 0.0 || (ratio > 0.0 && ratio < 1.0);
        let flight = self.flight(press, state, departure);
        let slow = |pull: f64, low: f64| flight.stays_below(low, pull);
        if !falls || !slow(back, LOW) {
            return Ok(None);
        }
        let collision = flow.collide(state, press, true, self.time)?;
        let pull = -self.bend(press, &collision.1.state, self.modes)?;
        let lasts = if approach > 0.0 {
            // s²/b + s/b: the same as 1/a + s/b.
            kept * (kept + 1.0) * departure / (pull * (1.0 - ratio))
        } else {
            0.0
        };
        if !slow(pull, LOW) {
            return Ok(None);
        }
        let verdict = self.rebounding(&collision, Vanishing::Both)?;
        if verdict.modes.as_slice()[press] != Mode::Rest {
            return Ok(None);
        }
        let moving = flow.system.moving(&collision.1.state, &verdict.modes)?;
        let reaction = moving.stick.as_ref()[press];
        let turns = || self.may_turn(press, state, (&moving, &verdict.modes), (ratio, lasts));
        if approach > 0.0 && !slow(pull, LOWEST) && turns() {
            return Ok(None);
        }
        Ok(
            (reaction.re + lasts * reaction.eps > 0.0).then_some(Rebound {
                collision,
                verdict,
                settles: Some(lasts),
            }),
        )
    }

    /// Whether friction under a press turns or sticks in what is left of a chatter, as far as an impact from a state and the
    /// motion after it tell: impulses to come take so many times as much from its speed.
    fn may_turn(
        &self,
        press: usize,
        state: &[f64; N],
        (after, modes): (&Snapshot<M, Dual64, N>, &Modes<M, N>),
        (ratio, lasts): (f64, f64),
    ) -> bool {
        let before = self.flow.system.speeds(state);
        let more = (1.0 + ratio) / (1.0 - ratio);
        let turns = |i: usize| {
            let speed = after.speed.as_ref()[i];
            let taken = more * (speed.re - before.as_ref()[i]).abs();
            let sticks = modes.as_slice()[i] == Mode::Stick;
            sticks || speed.re.abs() <= taken + (lasts * speed.eps).abs()
        };
        let rubbing = M::INFO.contacts.iter().enumerate();
        let mut under = rubbing.filter(|(_, contact)| contact.presses.contains(&press));
        under.any(|(i, _)| turns(i))
    }

    /// g̈ in flight.
    pub(super) fn bend(
        &self,
        press: usize,
        state: &[f64; N],
        modes: Modes<M, N>,
    ) -> Result<f64, FlowError> {
        let system = &self.flow.system;
        let field = system.moving(state, &modes)?.field;
        Ok(system.second_rates(state, &modes, &field).as_ref()[press])
    }

    /// The modes in which the gap opens: friction along its way turns where it does.
    fn leaving(&self, press: usize, state: &[f64; N]) -> Modes<M, N> {
        let system = &self.flow.system;
        Modes::from_fn(|i| match self.modes.as_slice()[i] {
            mode if mode.rubs() && system.is_tied(i, press) => {
                Mode::sliding(system.factor(state, i, press))
            }
            mode => mode,
        })
    }

    /// Makes one stretch of those before and between the impacts of a chatter: how many they are says nothing.
    pub(super) fn merge_chatter(&mut self, press: usize) {
        while let [.., first, last] = self.segments.as_mut_slice()
            && last.impact == Some(press)
            && first.mode == last.mode
        {
            first.duration += last.duration;
            self.segments.pop();
            if let [.., first, last] = self.factors.as_mut_slice() {
                *first = product(last, first);
                self.factors.pop();
            }
        }
    }

    /// A failure of the integrator, or what caused it.
    pub(super) fn explain(&self, mut error: IntegrationError) -> FlowError {
        if let IntegrationError::TooManySteps { steps, .. } = &mut error {
            *steps += self.work.steps + self.work.rejected;
        }
        if let IntegrationError::NotFinite { .. } = error
            && let Err(cause) = self.flow.system.snapshot(self.carried.state(), &self.modes)
        {
            return cause.into();
        }
        error.into()
    }

    /// Of numbers that have left all bounds contacts say nothing.
    pub(super) fn outgrown(&self, error: FlowError) -> FlowError {
        let cause = match error {
            FlowError::Contact(_) => "no forces of its contacts are determined any more",
            FlowError::Chattering { .. } | FlowError::InconsistentMode { .. } => {
                "rounding errors decide how its contacts go on"
            }
            _ => return error,
        };
        let unbounded = FlowError::unbounded(M::INFO, self.carried.state(), (self.time, cause));
        unbounded.unwrap_or(error)
    }
}
