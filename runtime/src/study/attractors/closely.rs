//! A start looked at closely: what it settles on, polished as far as it can be.

use super::ground::Ground;
use super::pursuit::Pursuit;
use super::record::{Attractor, Class};
use super::returns::returns;
use super::running::{Crossing, running, steady};
use super::statistics::irregular;
use crate::equilibrium::{Spectrum, settle};
use crate::flow::{FlowError, Want};
use crate::motion::{Passage, Place, apart, sticking};
use crate::shooting::{Orbit, OrbitError, changes_nothing, drawn, settled, slides};
use crate::study::equilibria::{sliding_mode, spelt};

/// Passages in which it is looked for rest, for a motion that runs, and for returns.
const PASSAGES: usize = 300;
/// Nothing moves by more than this, in usual sizes, where a motion rests.
const REST: f64 = 1e-9;
/// Over how many first passages a motion must have gone to be at rest.
const SOON: f64 = 4.0;
/// A rest and the equilibrium that it is are so far apart, in usual sizes, and a motion that has come back and its start.
const NEAR: f64 = 1e-5;
/// A motion leaves an orbit that has a larger multiplier.
const LEAVES: f64 = 1.01;
/// Returns this close, in usual sizes, may be those of an orbit to which the motion is drawn: one look is taken, and then one
/// when they are so many times closer. In the end it is followed until it settles there. Chaos comes back now and then, too:
/// the rarer, the closer, and it takes a hundred times longer to see that it stays on no orbit than to follow an orbit until
/// it comes back like that.
const CLOSE: f64 = 1e-2;
const CLOSER: f64 = 0.1;
const CLOSEST: f64 = 1e-5;

/// What a first look sees.
enum Look {
    Rest(Place),
    Running(Box<Attractor>),
    Drawn(Box<Orbit>),
    /// It comes back near where it was.
    Returning(Place),
    /// None of these yet.
    Roaming(Place),
}

impl Ground<'_> {
    /// What a start settles on.
    pub(super) fn closely(&self, start: &[f64]) -> Attractor {
        match self.seen(start) {
            Ok(found) => found,
            Err(error @ FlowError::Unbounded { .. }) => {
                Attractor::bare(Class::Escape, start, Some(error.to_string()))
            }
            // The motion goes on, but cannot be judged.
            Err(error @ FlowError::SensitivityUndefined(_)) => {
                Attractor::bare(Class::Unsettled, start, Some(error.to_string()))
            }
            Err(error) => Attractor::bare(Class::Failed, start, Some(error.to_string())),
        }
    }

    fn seen(&self, start: &[f64]) -> Result<Attractor, FlowError> {
        match self.look(start)? {
            Look::Rest(place) => self.rest(&place),
            Look::Running(found) => Ok(*found),
            Look::Drawn(orbit) => Ok(self.orbit(&orbit)),
            Look::Returning(place) => self.settled(&place.state, true),
            Look::Roaming(place) => match irregular(self, &place.state)? {
                Some(found) => Ok(found),
                None => self.settled(&place.state, false),
            },
        }
    }

    /// The orbit or the state of rest on which the motion from `start` settles; else what it is if it may be irregular.
    fn settled(&self, start: &[f64], may_roam: bool) -> Result<Attractor, FlowError> {
        let search = self.search(start.to_vec(), None);
        match settled(&self.family, 0.0, &search) {
            Ok(orbit) if self.holds(&orbit, start)? => Ok(self.orbit(&orbit)),
            Ok(orbit) => {
                let reason = format!(
                    "it comes back near an unstable orbit of the period {:.6e}, and does not stay there",
                    orbit.period
                );
                self.roaming(start, may_roam, reason)
            }
            Err(OrbitError::Equilibrium { state }) => self.rest(&self.flow.place(&state)?),
            Err(OrbitError::NotIsolated { state, .. }) => {
                Ok(Attractor::bare(Class::Family, &state, None))
            }
            Err(OrbitError::Flow(error)) => Err(error),
            Err(error) => self.roaming(start, may_roam, error.to_string()),
        }
    }

    /// The orbit to which the motion is drawn that came back so many crossings of its section before the last.
    fn drawn(&self, crossings: &[Crossing], turns: usize) -> Option<Orbit> {
        let [(before, _), .., (last, state)] = &crossings[crossings.len() - 1 - turns..] else {
            return None;
        };
        let search = self.search(state.clone(), None);
        drawn(&self.family, 0.0, &search, last - before).ok()
    }

    /// What a motion is that settles on no orbit: irregular, or not settled for a reason.
    fn roaming(
        &self,
        start: &[f64],
        may_roam: bool,
        reason: String,
    ) -> Result<Attractor, FlowError> {
        let irregular = if may_roam {
            irregular(self, start)?
        } else {
            None
        };
        let unsettled = || Attractor::bare(Class::Unsettled, start, Some(reason));
        Ok(irregular.unwrap_or_else(unsettled))
    }

    /// Whether a motion that comes by an orbit stays there: an unstable one keeps only what begins on it.
    fn holds(&self, orbit: &Orbit, start: &[f64]) -> Result<bool, FlowError> {
        if orbit.floquet.growth() <= LEAVES {
            return Ok(true);
        }
        let from = self.flow.place(start)?;
        let end = self.flow.advance(&from, orbit.period, Want::default())?.end;
        Ok(apart(&self.flow.wrapped(end.state), start, &self.usual) <= NEAR)
    }

    pub(super) fn orbit(&self, orbit: &Orbit) -> Attractor {
        let class = match (&orbit.shift, orbit.pins.as_slice()) {
            (Some(_), _) => Class::Running,
            (None, []) => Class::Orbit,
            (None, _) => Class::Family,
        };
        let shift = orbit.shift.as_ref();
        let found = Attractor {
            modes: orbit.place.modes.clone(),
            word: self.word(&orbit.segments),
            period: Some(orbit.period),
            min: orbit.min.clone(),
            max: orbit.max.clone(),
            slides: shift.is_some_and(|shift| slides(self.flow.as_ref(), shift, &self.usual)),
            shift: orbit.shift.clone(),
            points: orbit.section.clone(),
            section: orbit.crossed(self.flow.phase()),
            error: Some(orbit.error_estimate),
            ..Attractor::bare(class, &orbit.place.state, None)
        };
        found.judged(&orbit.floquet.multipliers, orbit.floquet.stability)
    }

    /// The state of rest at a place: sticking there, or the equilibrium to which Newton leads.
    pub(super) fn rest(&self, at: &Place) -> Result<Attractor, FlowError> {
        let info = self.system.info();
        if sticking(&at.modes) > 0 {
            let jacobian = self.flow.velocity(at)?.jacobian;
            let mut found = Attractor::bare(Class::Sticking, &at.state, None);
            found.modes = at.modes.clone();
            found.word = spelt(info, &at.modes);
            // The directions of the set, those that sticking takes, and a drive's phase say nothing of stability.
            let neutral = 2 * sticking(&at.modes) + usize::from(self.flow.phase().is_some());
            let spectrum = Spectrum::across(&jacobian, neutral);
            return Ok(found.judged(&spectrum.eigenvalues, spectrum.stability));
        }
        let mut at = at.clone();
        if self.touches() {
            at.modes = sliding_mode(self.flow.as_ref(), info, &at.state);
        }
        let exact = settle(&self.family, 0.0, &at);
        let exact = exact.filter(|one| apart(&one.place.state, &at.state, &self.usual) <= NEAR);
        Ok(match exact {
            Some(one) => {
                let mut found = Attractor::bare(Class::Equilibrium, &one.place.state, None);
                found.word = spelt(info, &one.place.modes);
                found.modes = one.place.modes;
                found.judged(&one.spectrum.eigenvalues, one.spectrum.stability)
            }
            None => {
                let reason = "it hardly moves, but no equilibrium is there".to_owned();
                Attractor::bare(Class::Unsettled, &at.state, Some(reason))
            }
        })
    }

    /// Looks for rest, and for a motion that runs.
    fn look(&self, start: &[f64]) -> Result<Look, FlowError> {
        let mut pursuit = Pursuit::new(self.flow.as_ref(), start)?;
        let mut crossings: Vec<Vec<Crossing>> = vec![Vec::new(); start.len()];
        let (mut first, mut close) = (None, CLOSE);
        for _ in 0..PASSAGES {
            let begun = pursuit.time;
            let passage = pursuit.on()?;
            let first = *first.get_or_insert(pursuit.time);
            if pursuit.time >= SOON * first && self.rests(&passage, pursuit.time - begun)? {
                return Ok(Look::Rest(pursuit.place));
            }
            if let Some(found) = steady(self, &passage)? {
                return Ok(Look::Running(Box::new(found)));
            }
            for (j, crossings) in crossings.iter_mut().enumerate() {
                let found = passage.minima(j);
                crossings.extend(found.map(|one| (begun + one.time, one.state.clone())));
            }
            let section = self
                .flow
                .phase()
                .or_else(|| crossings.iter().position(|all| !all.is_empty()));
            let Some(section) = section else {
                continue;
            };
            if let Some(found) = running(self, section, &crossings[section])? {
                return Ok(Look::Running(Box::new(found)));
            }
            let points = crossings[section].iter().map(|(_, state)| state);
            let Some(turns) = returns(points.rev(), &self.usual, close) else {
                continue;
            };
            if close <= CLOSEST {
                return Ok(Look::Returning(pursuit.place));
            }
            if let Some(orbit) = self.drawn(&crossings[section], turns) {
                return Ok(Look::Drawn(Box::new(orbit)));
            }
            close = (CLOSER * close).max(CLOSEST);
        }
        Ok(Look::Roaming(pursuit.place))
    }

    /// Whether nothing moved in a passage of this length, and nothing would in another one. Under a drive that takes a whole
    /// turn, and friction that holds through all of it.
    pub(super) fn rests(&self, passage: &Passage, time: f64) -> Result<bool, FlowError> {
        let drive = self.flow.phase();
        if let Some(phase) = drive
            && (passage.minima(phase).count() < 2 || sticking(&passage.end.modes) == 0)
        {
            return Ok(false);
        }
        let still = |j: usize| {
            let turns = passage
                .extrema
                .iter()
                .filter(|e| e.index == j)
                .map(|e| e.state[j]);
            let ends = [passage.calm.low[j], passage.calm.high[j]];
            let (low, high) = turns
                .chain(ends)
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), y| {
                    (l.min(y), h.max(y))
                });
            high - low <= REST * self.usual[j]
        };
        let states = || (0..self.usual.len()).filter(|j| drive != Some(*j));
        if !states().all(still) {
            return Ok(false);
        }
        let velocity = self.flow.velocity(&passage.end)?.f;
        let slow = |j: usize| velocity[j].abs() * time <= REST * self.usual[j];
        Ok(states().all(slow))
    }

    /// Whether a difference of states changes nothing.
    pub(super) fn is_copy(&self, a: &[f64], b: &[f64]) -> Option<Vec<f64>> {
        let shift: Vec<f64> = a.iter().zip(b).map(|(a, b)| a - b).collect();
        changes_nothing(self.flow.as_ref(), &shift, &self.usual).then_some(shift)
    }
}
