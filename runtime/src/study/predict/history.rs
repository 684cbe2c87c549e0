//! What an exact orbit does in one period, and its releases with what they cost a copy.

use super::PredictError;
use super::crossing::{Crossing, Passing};
use super::release::{Loss, Release};
use super::rubbing::Rubbing;
use super::scalar::{Local, Scalar};
use crate::field::Smoothing;
use crate::field::exact::Mode;
use crate::flow::{EventKind, Want};
use crate::integrate::Tolerance;
use crate::motion::{Event, Modes, Passage, Place};
use crate::shooting::Orbit;

/// Tolerance of the exact motion.
pub(super) const TIGHT: Tolerance = Tolerance::both(1e-12);

/// One period of an exact orbit.
pub(crate) struct History {
    pub(super) passage: Passage,
    pub(super) start: Place,
    pub(super) period: f64,
    /// The state that is the phase of a drive.
    pub(super) drive: Option<usize>,
    pub(super) switches: Vec<Switch>,
    /// What a copy loses is that of this one.
    pub(super) smoothing: Smoothing,
    /// Only the releases count, by their leading terms: neither creep nor tails.
    pub(super) leading: bool,
}

/// A switch of one contact, with the modes around it.
pub(super) struct Switch {
    pub(super) event: Event,
    pub(super) before: Place,
    pub(super) after: Place,
    pub(super) release: Option<Release>,
    pub(super) loss: Option<Loss>,
    pub(super) crossing: Option<Crossing>,
    pub(super) passing: Option<Passing>,
}

impl History {
    /// Follows the orbit once around.
    pub(super) fn of(
        model: &dyn Rubbing,
        orbit: &Orbit,
        smoothing: Smoothing,
    ) -> Result<Self, PredictError> {
        let mut start = orbit.place.clone();
        let flow = model.flow()?;
        let passage = flow.advance(&start, orbit.period, Want::EXTREMA)?;
        start.modes.resize(passage.end.modes.len(), Mode::Stick);
        let mut history = Self {
            passage,
            start,
            period: orbit.period,
            drive: flow.phase(),
            switches: Vec::new(),
            smoothing,
            leading: false,
        };
        history.find_switches(model)?;
        Ok(history)
    }

    fn find_switches(&mut self, model: &dyn Rubbing) -> Result<(), PredictError> {
        let mut modes = self.start.modes.clone();
        let events = self.passage.events.iter();
        let events: Vec<&Event> = events.filter(|event| event.kind.is_switch()).collect();
        for &event in &events {
            let place = |modes: &Modes| Place {
                state: event.state.clone(),
                modes: modes.clone(),
            };
            let before = place(&modes);
            modes[event.contact] = event.mode;
            let mut switch = Switch {
                event: event.clone(),
                before,
                after: place(&modes),
                release: None,
                loss: None,
                crossing: None,
                passing: None,
            };
            let room = self.room(event, &events);
            match event.kind {
                EventKind::Release { .. } => switch.release = Some(release(model, &switch, room)?),
                EventKind::Crossing { .. } => switch.crossing = crossing(model, &switch, room)?,
                _ => {}
            }
            self.switches.push(switch);
        }
        Ok(())
    }

    /// The times from the last switch of the same contact and to its next one.
    fn room(&self, event: &Event, switches: &[&Event]) -> [f64; 2] {
        [-1.0, 1.0].map(|way: f64| {
            let times = switches.iter().filter(|s| s.contact == event.contact);
            let share = times.map(|s| (way * (s.time - event.time) / self.period).rem_euclid(1.0));
            share.filter(|&t| t > 0.0).fold(1.0, f64::min) * self.period
        })
    }

    /// Finds what each release costs a copy, numerically or by its leading term, and what each crossing does in the end.
    pub(super) fn lose(&mut self, model: &dyn Rubbing, leading: bool) -> Result<(), PredictError> {
        self.leading = leading;
        let smoothing = &self.smoothing;
        for switch in &mut self.switches {
            let exact = |local: Local| Scalar {
                model,
                state: &switch.event.state,
                local,
                smoothing,
                copied: false,
            };
            // A bump is made for one direction of sliding: its copy does not cross.
            let crossing = switch
                .crossing
                .filter(|_| !leading && !smoothing.kernel.is_bump());
            let passing = crossing.map(|crossing| crossing.solve(exact(crossing.local)));
            switch.passing = passing.transpose()?;
            let Some(release) = &switch.release else {
                continue;
            };
            let loss = if leading {
                release.leading(smoothing)
            } else {
                release.solve(exact(release.local))?
            };
            switch.loss = Some(loss.ok_or(PredictError::NeverReleased {
                contact: model.contact_id(release.local.contact),
                smoothing: *smoothing,
            })?);
        }
        Ok(())
    }

    /// Where creep of a contact that sticks at `time` ends: at its next release.
    pub(super) fn cap(&self, contact: usize, time: f64) -> f64 {
        let own = self.switches.iter().filter(|s| s.event.contact == contact);
        let wait = |s: &&Switch| ((s.event.time - time) / self.period).rem_euclid(1.0);
        let releases = own.filter(|s| s.loss.is_some());
        let next = releases.min_by(|a, b| wait(a).total_cmp(&wait(b)));
        next.and_then(|s| s.loss).map_or(0.0, |loss| loss.creep_end)
    }

    /// Whether what a contact still lacks at `time` is not yet accounted for by its last release or by a crossing.
    pub(super) fn has_tail(&self, contact: usize, time: f64) -> bool {
        let since = |s: &Switch| (time - s.event.time).rem_euclid(self.period);
        let released = |s: &Switch| {
            let accounted = s.loss.map(|loss| loss.accounted.unwrap_or(f64::INFINITY));
            accounted.is_some_and(|accounted| since(s) < accounted)
        };
        let crosses = |s: &Switch| {
            let window = s.passing.map(|passing| passing.window);
            window
                .is_some_and(|[before, after]| since(s) < after || self.period - since(s) < before)
        };
        let mut own = self.switches.iter().filter(|s| s.event.contact == contact);
        !own.any(|s| released(s) || crosses(s))
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

fn release(
    model: &dyn Rubbing,
    switch: &Switch,
    [stuck, slides]: [f64; 2],
) -> Result<Release, PredictError> {
    let contact = switch.event.contact;
    let load = model.load(&switch.before, contact)?;
    Ok(Release {
        local: Local {
            contact,
            way: switch.after.modes[contact].sign(),
            acceleration: load.compliance * load.rate,
            compliance: load.compliance,
            stick: load.stick,
        },
        time: switch.event.time,
        load_rate: load.rate,
        slip: load.slip,
        stuck,
        slides,
    })
}

/// `None` where no friction force jumps.
fn crossing(
    model: &dyn Rubbing,
    switch: &Switch,
    room: [f64; 2],
) -> Result<Option<Crossing>, PredictError> {
    let contact = switch.event.contact;
    let way = switch.after.modes[contact].sign();
    let (before, slip) = model.approach(&switch.before, contact)?;
    let (after, _) = model.approach(&switch.after, contact)?;
    let rates = [way * before, way * after];
    let compliance = (rates[0] - rates[1]) / (2.0 * slip);
    let crossing = Crossing {
        local: Local {
            contact,
            way,
            acceleration: 0.0,
            compliance,
            stick: (rates[0] + rates[1]) / (2.0 * compliance),
        },
        time: switch.event.time,
        rates,
        room,
    };
    let jumps = compliance.is_finite() && compliance > 0.0 && rates[1] > 0.0;
    Ok(jumps.then_some(crossing))
}
