//! What an exact orbit does in one period, and its releases with what they cost a copy.

use super::PredictError;
use super::release::{Loss, Release};
use super::scalar::Local;
use crate::field::Smoothing;
use crate::field::exact::{ExactSystem, Mode, Modes, solve};
use crate::flow::exact::ExactFlow;
use crate::flow::{Event, EventKind, Flow, Passage, Want};
use crate::integrate::Tolerance;
use crate::model::Model;
use crate::scalar::Inline;
use crate::shooting::Orbit;

/// Tolerance of the exact motion.
pub(super) const TIGHT: Tolerance = Tolerance {
    relative: 1e-12,
    absolute: 1e-12,
};

/// One period of an exact orbit.
pub(super) struct History<M: Model<N>, const N: usize> {
    pub(super) system: ExactSystem<M, N>,
    pub(super) passage: Passage<N, Modes<M, N>>,
    pub(super) start: [f64; N],
    pub(super) modes: Modes<M, N>,
    pub(super) period: f64,
    pub(super) switches: Vec<Switch<M, N>>,
}

/// A switch of one contact, with the modes around it.
pub(super) struct Switch<M: Model<N>, const N: usize> {
    pub(super) event: Event<N>,
    pub(super) before: Modes<M, N>,
    pub(super) after: Modes<M, N>,
    pub(super) release: Option<Release<N>>,
    pub(super) loss: Option<Loss>,
}

impl<M: Model<N>, const N: usize> History<M, N> {
    /// Follows the orbit once around.
    pub(super) fn of(model: &M, orbit: &Orbit<N, Modes<M, N>>) -> Result<Self, PredictError> {
        let flow = ExactFlow::new(model, None, TIGHT)?;
        let want = Want {
            extrema: true,
            ..Want::default()
        };
        let passage = flow.advance(&orbit.place, orbit.period, want)?;
        let mut history = Self {
            system: ExactSystem::new(model, None),
            start: orbit.place.state,
            modes: orbit.place.mode,
            period: orbit.period,
            switches: Vec::new(),
            passage,
        };
        history.find_switches()?;
        Ok(history)
    }

    fn find_switches(&mut self) -> Result<(), PredictError> {
        let mut modes = self.modes;
        let events: Vec<Event<N>> = self.passage.events.clone();
        let switches: Vec<&Event<N>> = events.iter().filter(|event| event.is_switch()).collect();
        for (place, event) in switches.iter().enumerate() {
            let before = modes;
            modes.set(event.contact, event.mode);
            let release = match event.kind {
                EventKind::Release { .. } => {
                    Some(self.release(event, &before, &modes, (&switches, place))?)
                }
                _ => None,
            };
            self.switches.push(Switch {
                event: **event,
                before,
                after: modes,
                release,
                loss: None,
            });
        }
        Ok(())
    }

    fn release(
        &self,
        event: &Event<N>,
        before: &Modes<M, N>,
        after: &Modes<M, N>,
        (switches, place): (&[&Event<N>], usize),
    ) -> Result<Release<N>, PredictError> {
        let (i, state) = (event.contact, event.state);
        let moving = self.system.moving(&state, before)?;
        let affine = self.system.affine(&state, before);
        let unit = Inline::from_fn(|j| f64::from(i == j));
        let stuck = |j: usize| before.as_slice()[j] == Mode::Stick;
        let response = solve::<M, f64, N>(affine.compliance, unit, stuck);
        let response = response.map_or(f64::NAN, |u| u.as_ref()[i]);
        let compliance = 1.0 / response;
        let load_rate = moving.force.as_ref()[i].eps.abs();
        let around = |later: bool| {
            let times = switches.iter().filter(|other| other.contact == i);
            let times = times.map(|other| (other.time - event.time) / self.period);
            let share = times.map(|t| if later { t } else { -t }.rem_euclid(1.0));
            share.filter(|&t| t > 0.0).fold(1.0, f64::min) * self.period
        };
        debug_assert_eq!(switches[place].contact, i);
        Ok(Release {
            local: Local {
                state,
                contact: i,
                way: after.as_slice()[i].sign(),
                acceleration: compliance * load_rate,
                compliance,
                stick: moving.stick.as_ref()[i].re,
            },
            time: event.time,
            load_rate,
            slip: self.system.limits_at_rest(&state).as_ref()[i].1,
            stuck: around(false),
            slides: around(true),
        })
    }

    /// Finds what each release costs a copy, numerically or by its leading term.
    pub(super) fn lose(
        &mut self,
        model: &M,
        smoothing: &Smoothing,
        leading: bool,
    ) -> Result<(), PredictError> {
        for switch in &mut self.switches {
            let Some(release) = &switch.release else {
                continue;
            };
            let loss = if leading {
                release.leading(smoothing)
            } else {
                release.solve(model, smoothing)?
            };
            switch.loss = Some(loss.ok_or(PredictError::NeverReleased {
                contact: release.local.contact,
                smoothing: *smoothing,
            })?);
        }
        Ok(())
    }

    /// Where creep ends for each contact that sticks at `time`: at its next release.
    pub(super) fn caps(&self, time: f64) -> M::PerContact<f64> {
        Inline::from_fn(|i| {
            let releases = self
                .switches
                .iter()
                .filter(|s| s.event.contact == i && s.loss.is_some());
            let wait = |s: &&Switch<M, N>| {
                let wait = (s.event.time - time) / self.period;
                wait.rem_euclid(1.0)
            };
            let next = releases.min_by(|a, b| wait(a).total_cmp(&wait(b)));
            next.and_then(|s| s.loss).map_or(0.0, |loss| loss.creep_end)
        })
    }

    /// Whether what a contact still lacks at `time` is not yet accounted for by its last release.
    pub(super) fn tails(&self, time: f64) -> M::PerContact<bool> {
        Inline::from_fn(|i| {
            self.switches.iter().all(|s| match s.loss {
                Some(loss) if s.event.contact == i => {
                    let since = (time - s.event.time).rem_euclid(self.period);
                    loss.accounted.is_some_and(|accounted| since >= accounted)
                }
                _ => true,
            })
        })
    }

    /// Times at which something changes within (0, T), in order: switches, ends of releases, and `also`.
    pub(super) fn instants(&self, also: &[f64]) -> Vec<f64> {
        let ends = self.switches.iter().filter_map(|s| {
            let end = s.event.time + s.loss?.accounted?;
            Some(end.rem_euclid(self.period))
        });
        let switches = self.switches.iter().map(|s| s.event.time);
        let mut times: Vec<f64> = switches.chain(ends).chain(also.iter().copied()).collect();
        times.push(self.period);
        times.retain(|&t| t > 0.0 && t <= self.period);
        times.sort_by(f64::total_cmp);
        times.dedup();
        times
    }
}
