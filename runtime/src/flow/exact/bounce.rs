//! Impacts on a motion under way: the state jumps, and its derivatives with it.

use super::collide::Collision;
use super::press::Vanishing;
use super::run::Run;
use super::settle::{Rest, Verdict};
use super::switch::{ROUNDING, Strike};
use crate::field::exact::{Mode, Modes};
use crate::flow::saltation::{Reset, Saltation};
use crate::flow::{Event, EventKind, FlowError, SensitivityUndefined};
use crate::model::Model;
use crate::scalar::{Inline, Lanes, mapped};

/// How an impact goes on.
pub(super) struct Rebound<M: Model<N>, const N: usize> {
    pub(super) collision: Collision<M, N>,
    pub(super) verdict: Verdict<M, N>,
    /// For how long others would follow that are taken at once, if it ends a chatter.
    pub(super) settles: Option<f64>,
}

impl<M: Model<N>, const N: usize> Run<'_, M, N> {
    /// The press that is hit at this instant, if one that does not give way is.
    ///
    /// # Errors
    /// Several are, and act on each other.
    pub(super) fn hit(&self, strike: &Strike<M, N>) -> Result<Option<usize>, FlowError> {
        let flies = |i: usize| M::INFO.is_rigid(i) && self.modes.as_slice()[i] == Mode::Open;
        let closes = |i: &usize| flies(*i) && strike.fallen.as_ref()[*i].is_some();
        let hit: Vec<usize> = (0..strike.fallen.as_ref().len()).filter(closes).collect();
        let state = self.carried.state();
        let acts = |a: usize, b: usize| a != b && self.flow.system.acts_on(state, a, b);
        if hit.iter().any(|&a| hit.iter().any(|&b| acts(a, b))) {
            return Err(FlowError::HitTogether {
                contacts: hit.into_iter().map(|i| M::INFO.contact_id(i)).collect(),
                time: self.time,
            });
        }
        Ok(hit.first().copied())
    }

    /// Passes an impact; whatever else falls at this instant falls again after it.
    pub(super) fn bounce(&mut self, press: usize, strike: &Strike<M, N>) -> Result<(), FlowError> {
        let state = *self.carried.state();
        let rebound = match self.settling(press, &state)? {
            Some(settling) => settling,
            None => self.parting(press, &state)?,
        };
        let rebound = self.at_rest_together(&rebound)?.unwrap_or(rebound);
        let (impulses, impact) = &rebound.collision;
        self.jump(press, strike, &rebound)?;
        self.close_segment();
        self.impact = Some(press);
        let (approach, departure) = (impact.approach, impact.departure);
        let kind = match rebound.settles {
            Some(lasts) => {
                self.merge_chatter(press);
                EventKind::Settled { approach, lasts }
            }
            None => EventKind::Impact {
                approach,
                departure,
            },
        };
        self.extrema.jump(self.time, &state, &impact.state);
        *self.carried.state_mut() = impact.state;
        self.sample(self.time, impact.state);
        self.work.events += 1;
        self.events.push(Event {
            kind,
            contact: press,
            mode: rebound.verdict.modes.as_slice()[impulses.press],
            time: self.time,
            state: impact.state,
            rate: -approach,
        });
        self.take(&rebound.verdict, &Inline::from_fn(|_| 0.0))?;
        self.count_chatter(press)
    }

    /// An impact after which the gap opens, or could if the law makes nothing of its speed.
    fn parting(&self, press: usize, state: &[f64; N]) -> Result<Rebound<M, N>, FlowError> {
        // Where a wall is only touched, rounding errors may be all that is left of the speed.
        let touches = self.flow.system.approach(state, press).0 <= 0.0;
        let collision = self.flow.collide(state, press, touches, self.time)?;
        let vanishing = if collision.1.departure > 0.0 {
            Vanishing::Gap
        } else {
            Vanishing::Both
        };
        Ok(Rebound {
            verdict: self.rebounding(&collision, vanishing)?,
            collision,
            settles: None,
        })
    }

    /// Takes Φ and p through the jump.
    fn jump(
        &mut self,
        press: usize,
        strike: &Strike<M, N>,
        rebound: &Rebound<M, N>,
    ) -> Result<(), FlowError> {
        let (system, time, before) = (&self.flow.system, self.time, self.modes);
        let state = *self.carried.state();
        let (impulses, impact) = &rebound.collision;
        let Some(motion) = self.carried.motion() else {
            return Ok(());
        };
        let (gradient, design) = system.linear_speeds(&state).as_ref()[press].slopes();
        let linear = system.linear_impact(&state, impulses)?.state;
        let slopes: [([f64; N], f64); N] = crate::scalar::filled(|i| linear[i].slopes());
        let reset = Reset {
            slopes: mapped(&slopes, |(state, _)| state),
            design: mapped(&slopes, |(_, design)| design),
        };
        let saltation = Saltation {
            before: system.snapshot(&state, &before)?.field,
            after: system
                .snapshot(&impact.state, &rebound.verdict.modes)?
                .field,
            gradient,
            design,
            magnitude: system.magnitude,
        };
        let passed = saltation.reset(motion, &reset, strike.grazes);
        let found = passed.map_err(|rate| SensitivityUndefined::Grazing {
            contact: M::INFO.contact_id(press),
            time,
            rate,
        })?;
        self.jumps = self.jumps.times(found.volumes);
        self.rounding = self.rounding.max(strike.rounding(press) * found.leap);
        Ok(())
    }

    /// The modes after an impact: other contacts as their speeds are then, which it may have changed.
    pub(super) fn rebounding(
        &self,
        (impulses, impact): &Collision<M, N>,
        vanishing: Vanishing,
    ) -> Result<Verdict<M, N>, FlowError> {
        let (flow, press, state) = (self.flow, impulses.press, &impact.state);
        let known = |i: usize| {
            Some(if i == press {
                vanishing
            } else {
                Vanishing::Rounded
            })
        };
        let presses = flow.with_presses(state, self.modes, &known);
        let presses = presses.map_err(|error| self.together(error, press))?;
        let (speeds, scales) = (flow.system.speeds(state), flow.speed_scales(state));
        let speed = |i: usize| speeds.as_ref()[i];
        let held = |i: usize| impulses.modes.as_slice()[i] == Mode::Stick;
        let rest = |modes: Modes<M, N>| {
            let modes = modes.as_slice();
            let still = |i: usize| held(i) || speed(i).abs() <= ROUNDING * scales.as_ref()[i];
            let resting: M::PerContact<bool> =
                Inline::from_fn(|i| modes[i].rubs() && !flow.system.is_idle(i) && still(i));
            Rest {
                system: &flow.system,
                arrival: flow.arrival,
                state: *state,
                time: self.time,
                before: Modes::from_fn(|i| match modes[i] {
                    mode if !mode.rubs() => mode,
                    _ if resting.as_ref()[i] => Mode::Stick,
                    _ => Mode::sliding(speed(i)),
                }),
                resting,
                let_go: Inline::from_fn(|_| 0.0),
            }
        };
        flow.borne(state, self.time, &presses, &rest)
    }

    /// What is hit while others are closed that it presses on is hit with them.
    fn together(&self, error: FlowError, press: usize) -> FlowError {
        error.hit_with(M::INFO.contact_id(press), self.time)
    }
}
