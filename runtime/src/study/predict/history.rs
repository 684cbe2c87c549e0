//! What an exact orbit does in one period, and its releases with what they cost a copy.

use super::PredictError;
use super::crossing::{Crossing, Passing};
use super::release::{Loss, Release};
use super::scalar::Local;
use crate::field::Smoothing;
use crate::field::exact::{ExactSystem, Mode, Modes, solve};
use crate::flow::exact::ExactFlow;
use crate::flow::{self, Event, EventKind, Flow, Passage, Want};
use crate::integrate::Tolerance;
use crate::model::Model;
use crate::motion::Place;
use crate::scalar::{Inline, Lanes};
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
    pub(super) crossing: Option<Crossing<N>>,
    pub(super) passing: Option<Passing>,
}

impl<M: Model<N>, const N: usize> History<M, N> {
    /// Follows the orbit once around.
    pub(super) fn of(model: &M, orbit: &Orbit) -> Result<Self, PredictError> {
        let flow = ExactFlow::new(model, None, TIGHT)?;
        let want = Want {
            extrema: true,
            ..Want::default()
        };
        let Place { state, modes } = &orbit.place;
        let start: [f64; N] = std::array::from_fn(|j| state.get(j).copied().unwrap_or(f64::NAN));
        let modes = Modes::from_fn(|i| modes.get(i).copied().unwrap_or(Mode::Stick));
        let place = flow::Place {
            state: start,
            mode: modes,
        };
        let passage = flow.advance(&place, orbit.period, want)?;
        let mut history = Self {
            system: ExactSystem::new(model, None),
            start,
            modes,
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
        let switches: Vec<&Event<N>> = events
            .iter()
            .filter(|event| event.kind.is_switch())
            .collect();
        for event in &switches {
            let before = modes;
            modes.set(event.contact, event.mode);
            let room = self.room(event, &switches);
            let mut switch = Switch {
                event: **event,
                before,
                after: modes,
                release: None,
                loss: None,
                crossing: None,
                passing: None,
            };
            match event.kind {
                EventKind::Release { .. } => {
                    switch.release = Some(self.release(event, &before, &modes, room)?);
                }
                EventKind::Crossing { .. } => {
                    switch.crossing = self.crossing(event, &before, &modes, room)?;
                }
                _ => {}
            }
            self.switches.push(switch);
        }
        Ok(())
    }

    /// The times from the last switch of the same contact and to its next one.
    fn room(&self, event: &Event<N>, switches: &[&Event<N>]) -> [f64; 2] {
        [-1.0, 1.0].map(|way: f64| {
            let times = switches.iter().filter(|s| s.contact == event.contact);
            let share = times.map(|s| (way * (s.time - event.time) / self.period).rem_euclid(1.0));
            share.filter(|&t| t > 0.0).fold(1.0, f64::min) * self.period
        })
    }

    fn release(
        &self,
        event: &Event<N>,
        before: &Modes<M, N>,
        after: &Modes<M, N>,
        [stuck, slides]: [f64; 2],
    ) -> Result<Release<N>, PredictError> {
        let (i, state) = (event.contact, event.state);
        let moving = self.system.moving(&state, before)?;
        let affine = self.system.affine(&state, before);
        let unit = Inline::from_fn(|j| f64::from(i == j));
        let held = |j: usize| before.as_slice()[j] == Mode::Stick;
        let response = solve::<M, f64, N>(affine.compliance, unit, held);
        let response = response.map_or(f64::NAN, |u| u.as_ref()[i]);
        let compliance = 1.0 / response;
        let load_rate = moving.force.as_ref()[i].eps.abs();
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
            stuck,
            slides,
        })
    }

    /// `None` where no friction force jumps.
    fn crossing(
        &self,
        event: &Event<N>,
        before: &Modes<M, N>,
        after: &Modes<M, N>,
        room: [f64; 2],
    ) -> Result<Option<Crossing<N>>, PredictError> {
        let (i, state) = (event.contact, event.state);
        let way = after.as_slice()[i].sign();
        let (gradient, _): ([f64; N], f64) = self.system.linear_speeds(&state).as_ref()[i].slopes();
        let mut rates = [0.0; 2];
        for (rate, modes) in rates.iter_mut().zip([before, after]) {
            let field = self.system.snapshot(&state, modes)?.field;
            let along = gradient.iter().zip(&field).map(|(g, f)| g * f);
            *rate = way * along.sum::<f64>();
        }
        let slip = self.system.limits_at_rest(&state).as_ref()[i].1;
        let compliance = (rates[0] - rates[1]) / (2.0 * slip);
        let crossing = Crossing {
            local: Local {
                state,
                contact: i,
                way,
                acceleration: 0.0,
                compliance,
                stick: (rates[0] + rates[1]) / (2.0 * compliance),
            },
            time: event.time,
            rates,
            room,
        };
        let jumps = compliance.is_finite() && compliance > 0.0 && rates[1] > 0.0;
        Ok(jumps.then_some(crossing))
    }

    /// Finds what each release costs a copy, numerically or by its leading term, and what each crossing does in the end.
    pub(super) fn lose(
        &mut self,
        model: &M,
        smoothing: &Smoothing,
        leading: bool,
    ) -> Result<(), PredictError> {
        for switch in &mut self.switches {
            // A bump is made for one direction of sliding: its copy does not cross.
            let crossing = switch
                .crossing
                .filter(|_| !leading && !smoothing.kernel.is_bump());
            let passing = crossing.map(|crossing| crossing.solve(model, smoothing));
            switch.passing = passing.transpose()?;
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

    /// Whether what a contact still lacks at `time` is not yet accounted for by its last release or by a crossing.
    pub(super) fn tails(&self, time: f64) -> M::PerContact<bool> {
        let since = |s: &Switch<M, N>| (time - s.event.time).rem_euclid(self.period);
        let released = |s: &Switch<M, N>| {
            let accounted = s.loss.map(|loss| loss.accounted.unwrap_or(f64::INFINITY));
            accounted.is_some_and(|accounted| since(s) < accounted)
        };
        let crosses = |s: &Switch<M, N>| {
            let window = s.passing.map(|passing| passing.window);
            window
                .is_some_and(|[before, after]| since(s) < after || self.period - since(s) < before)
        };
        Inline::from_fn(|i| {
            let mut own = self.switches.iter().filter(|s| s.event.contact == i);
            !own.any(|s| released(s) || crosses(s))
        })
    }

    /// Times at which something changes within (0, T), in order: switches, ends of releases, and `also`.
    pub(super) fn instants(&self, also: &[f64]) -> Vec<f64> {
        let ends = self.switches.iter().flat_map(|s| {
            let released = s.loss.and_then(|loss| loss.accounted);
            let window = s.passing.map(|passing| passing.window);
            let around = window.map(|[before, after]| [-before, after]);
            let ends = released.into_iter().chain(around.into_iter().flatten());
            ends.map(|end| (s.event.time + end).rem_euclid(self.period))
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
