//! A first guess: let the motion settle, and watch it come back to its section.

use std::f64::consts::TAU;

use super::fading::{fades_to, is_slow};
use super::guess::{Guess, magnitude_of};
use super::quiet::Quiet;
use super::shift::Shifts;
use super::turning::{half, turning};
use crate::flow::{FlowError, Want};
use crate::motion::{Flow, Modes, NOISE, Passage, Place, STILL, apart, bounds, is_still};
use crate::poincare::radian;

/// Most minima of the first state that are awaited.
const PATIENCE: usize = 3000;
/// Most steps of the integrator that are spent on it, and most states that they advance: a step costs as its states do.
const STEPS: u64 = 500_000;
const ADVANCED: u64 = 4_000_000;
/// States beyond which they are many.
const MANY: usize = 16;
/// Crossings in a chunk that suffice.
const ENOUGH: usize = 2;
/// Chunks without a crossing after which the motion is no oscillation.
const SILENCE: u32 = 60;
/// An oscillation this small, relative to its first swing, has settled on an equilibrium.
const VANISHED: f64 = 1e-7;

/// Where a settling motion ended.
#[derive(Debug, Clone, PartialEq)]
pub enum Settled<T> {
    /// `accept` was satisfied with a guess.
    Orbit(T),
    /// It came to rest here, to these errors.
    Equilibrium(Vec<f64>, Vec<f64>),
    /// Neither, after this time; where it had come by then.
    Neither(f64, Place),
}

/// Follows the motion from `start` until `accept` takes one of the guesses it offers, or it comes to rest; guesses have
/// periods of up to `longest` crossings of the section.
///
/// # Errors
/// The motion cannot be followed.
pub fn settle<T>(
    flow: &dyn Flow,
    start: Place,
    longest: usize,
    mut accept: impl FnMut(&Guess) -> Option<T>,
) -> Result<Settled<T>, FlowError> {
    let mut chunk = radian(flow, &start)?;
    let mut watch = Watch::new(start, flow.phase().unwrap_or(0));
    let mut silent = 0;
    let steps = STEPS.min(ADVANCED / flow.order().max(1) as u64);
    while watch.minima.len() < PATIENCE && silent < SILENCE && watch.steps < steps {
        let crossings = watch.follow(flow, chunk)?;
        let still = crossings < ENOUGH;
        // Where it swings no more, its last swing says nothing of what it does.
        let rests = match still {
            true => watch.quiet.lasts(),
            false => watch.has_faded() && !watch.moves_elsewhere(flow),
        };
        if flow.phase().is_none() && rests {
            return Ok(watch.rest());
        }
        let undriven = flow.phase().is_none();
        let fades = undriven.then(|| fades_to(flow, &watch.place, watch.quiet.extents()));
        if let Some(equilibrium) = fades.flatten() {
            return Ok(Settled::Equilibrium(equilibrium, watch.quiet.errors()));
        }
        chunk *= if still { 2.0 } else { 1.0 };
        silent = if still { silent + 1 } else { 0 };
        for guess in watch.guesses(flow, longest)? {
            if let Some(orbit) = accept(&guess) {
                return Ok(Settled::Orbit(orbit));
            }
        }
    }
    Ok(if is_slow(flow, &watch.place, &watch.extent, watch.time)? {
        watch.rest()
    } else {
        Settled::Neither(watch.time, watch.place)
    })
}

/// A minimum of the section's state.
#[derive(Debug, Clone)]
struct Minimum {
    time: f64,
    state: Vec<f64>,
    /// Those on the way, if they do not change there.
    modes: Option<Modes>,
}

struct Watch {
    place: Place,
    time: f64,
    minima: Vec<Minimum>,
    /// Minima already offered as guesses.
    offered: usize,
    /// A return must be this close to be offered.
    closeness: f64,
    /// The state whose minima are its section.
    section: usize,
    /// The shifts that change nothing, once they are asked for.
    shifts: Option<Shifts>,
    extent: Vec<f64>,
    /// The widest extent that each state had.
    widest: Vec<f64>,
    /// What is usual for each state, as far as the start tells.
    usual: Vec<f64>,
    first_extent: f64,
    swings: Vec<f64>,
    quiet: Quiet,
    steps: u64,
}

impl Watch {
    fn new(place: Place, section: usize) -> Self {
        Self {
            section,
            shifts: None,
            extent: vec![0.0; place.state.len()],
            widest: vec![0.0; place.state.len()],
            usual: magnitude_of(&place.state),
            quiet: Quiet::new(place.state.len()),
            place,
            time: 0.0,
            minima: Vec::new(),
            offered: 0,
            closeness: 3e-2,
            first_extent: 0.0,
            swings: Vec::new(),
            steps: 0,
        }
    }

    /// At rest where it is.
    fn rest<T>(&self) -> Settled<T> {
        Settled::Equilibrium(self.place.state.clone(), self.quiet.errors())
    }

    /// Follows one chunk; returns the number of minima in it.
    fn follow(&mut self, flow: &dyn Flow, chunk: f64) -> Result<usize, FlowError> {
        // Of a driven motion of many states that does not run on, the ends of steps tell enough of how far it swings: to look
        // for the extrema of each costs more than the motion.
        let stays = self.shifts.as_ref().is_some_and(Shifts::is_empty);
        let driven = flow.phase().is_some() && flow.order() > MANY && stays;
        let want = if driven { Want::STROBES } else { Want::EXTREMA };
        let passage = flow.advance(&self.place, chunk, want);
        let passage = passage.map_err(|error| error.later(self.time))?;
        self.steps += passage.work.steps + passage.work.rejected;
        let before = self.minima.len();
        // One that may run on goes on after a rest with which a passage begins as it came.
        let mut minima = passage.lows(self.section).peekable();
        let rests = minima.next_if(|first| first.time == 0.0);
        let rests = rests.filter(|_| !Shifts::of(flow, &self.magnitude()).may_run(self.section));
        self.minima
            .extend(rests.into_iter().chain(minima).map(|one| Minimum {
                time: self.time + one.time,
                state: one.state.clone(),
                modes: passage.modes_within(one.time).cloned(),
            }));
        let run = self.run(&passage.end.state);
        let (mut low, mut high) = match driven {
            true => (passage.calm.low.clone(), passage.calm.high.clone()),
            false => bounds(&passage, &run, chunk),
        };
        let crossings = self.minima.len() - before;
        self.quiet.take(chunk, &self.place.state, [&low, &high]);
        if self.minima.is_empty() && self.turned_away(flow, &passage, chunk) {
            self.place = passage.end;
            self.time += chunk;
            return Ok(ENOUGH);
        }
        // A motion that creeps to rest has been somewhere else, too.
        let reach = (self.place.state[0] - low[0]).abs().max(high[0] - low[0]);
        self.first_extent = self.first_extent.max(reach);
        if crossings >= ENOUGH {
            if let Some(phase) = flow.phase() {
                (low[phase], high[phase]) = (0.0, TAU);
            }
            let bounds = high.iter().zip(&low);
            self.extent = bounds.map(|(high, low)| high - low).collect();
            for (widest, extent) in self.widest.iter_mut().zip(&self.extent) {
                *widest = widest.max(*extent);
            }
            self.swings.push(self.extent[0].max(run[0].abs()));
        }
        self.place = passage.end;
        self.place.state = flow.wrapped(std::mem::take(&mut self.place.state));
        self.time += chunk;
        Ok(crossings)
    }

    /// What of the way to the end of a chunk is a shift that changes nothing.
    fn run(&self, end: &[f64]) -> Vec<f64> {
        let shifts = self.shifts.as_ref();
        shifts.map_or_else(
            || vec![0.0; end.len()],
            |shifts| shifts.between(&self.place.state, end),
        )
    }

    /// Whether the first state hardly swings any more.
    fn has_faded(&self) -> bool {
        let size = self.place.state[0].abs().max(self.first_extent);
        self.swings
            .last()
            .is_some_and(|&swing| swing <= VANISHED * size)
    }

    /// Whether others move though the first state does not: it need not feel them.
    fn moves_elsewhere(&self, flow: &dyn Flow) -> bool {
        let moving = self.quiet.moving(&self.place.state, &self.extent);
        let shifts = || Shifts::of(flow, &self.magnitude());
        !moving.is_empty() && !moving.iter().all(|&j| shifts().may_run(j))
    }

    /// New returns to the section that are close enough; later ones must be closer.
    fn guesses(&mut self, flow: &dyn Flow, longest: usize) -> Result<Vec<Guess>, FlowError> {
        let mut guesses = Vec::new();
        if self.minima.len() > 1 && self.shifts.is_none() {
            self.shifts = Some(Shifts::of(flow, &self.magnitude()));
        }
        for last in self.offered..self.minima.len() {
            let here = &self.minima[last];
            let close = (1..=longest.min(last)).find_map(|k| Some((k, self.returns(last, k)?)));
            if let Some((k, shift)) = close {
                let state = match (&shift, &self.shifts) {
                    (Some(_), Some(shifts)) => shifts.home(&here.state),
                    _ => here.state.clone(),
                };
                let place = Place::known(flow, &state, here.modes.as_ref())?;
                let period = here.time - self.minima[last - k].time;
                guesses.push(Guess {
                    place,
                    period,
                    magnitude: self.magnitude(),
                    pins: Vec::new(),
                    shift,
                    division: None,
                });
            }
        }
        self.offered = self.minima.len();
        if guesses.len() > 1 {
            guesses.drain(..guesses.len() - 1);
        }
        if !guesses.is_empty() {
            self.closeness = (0.7 * self.closeness).max(1e-6);
        }
        Ok(guesses)
    }

    /// Whether the motion came back `k` minima before this one, and but for which shift.
    fn returns(&self, last: usize, k: usize) -> Option<Option<Vec<f64>>> {
        let (here, before) = (&self.minima[last].state, &self.minima[last - k].state);
        if self.distance(here, before) < self.closeness {
            return Some(None);
        }
        let shifts = self.shifts.as_ref().filter(|shifts| !shifts.is_empty())?;
        let shift = shifts.within([before, here], &self.magnitude(), self.closeness)?;
        Some(Some(shift))
    }

    /// Where the first state only runs on, another one that turns often is the section's from now on.
    fn turned_away(&mut self, flow: &dyn Flow, passage: &Passage, chunk: f64) -> bool {
        let Some((other, shifts)) = turning(flow, passage, chunk) else {
            return false;
        };
        let runs = shifts.may_run(self.section);
        if runs {
            self.section = other;
        }
        self.shifts = Some(shifts);
        runs
    }

    /// Half of what each state swings by; what keeps still is measured in what it is, what died away in what it was.
    fn magnitude(&self) -> Vec<f64> {
        let swing = |j: usize| {
            let (widest, state) = (self.widest[j], self.place.state[j].abs());
            match is_still(self.extent[j], state) {
                _ if widest <= NOISE * self.usual[j] => half(0.0),
                _ if self.extent[j] <= STILL * widest => half(widest),
                true => state,
                false => half(self.extent[j]),
            }
        };
        (0..self.extent.len()).map(swing).collect()
    }

    fn distance(&self, a: &[f64], b: &[f64]) -> f64 {
        apart(a, b, &self.magnitude())
    }
}
