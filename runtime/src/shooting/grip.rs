//! Contacts that stick all along an orbit: what friction holds in one place, until it lets go.

use std::f64::consts::TAU;

use super::conserved::{is_conserved, is_driven};
use super::orbit::Orbit;
use super::pin::Pin;
use super::problem::OrbitProblem;
use super::shot::Shot;
use super::sought::Search;
use crate::continuation::{Beyond, Crossing, Kind, Located, Started, Watched};
use crate::field::exact::Mode;
use crate::flow::{FlowError, Want};
use crate::motion::{Flow, Node, Passage, Place};

/// A pinned orbit that closes no better than this is none; or than this over the accuracy, where that is loose.
const CLOSED: f64 = 1e-5;
const UNCLOSED: f64 = 100.0;
/// Relative change of the period up to which an orbit is that to which a branch comes where a contact begins to slide, or
/// ceases to: what slides has hardly an extent, by which orbits could be compared.
const REACH: f64 = 1e-2;
/// Panels of a quadrature over an orbit.
const PANELS: f64 = 50.0;
/// Share of its period for which a contact slides at most that may not do so at all, and how far it slides then, over the way
/// that the states could carry it in that period and over the accuracy.
const BRIEFLY: f64 = 0.1;
const SLIDES: f64 = 0.1;
/// What shares of a period may add up to besides 1.
const ROUNDING: f64 = 1e-9;
/// What the errors of three orbits may add up to, over one of them.
const NOISE: f64 = 10.0;

impl Shot {
    /// The contacts that stick all along.
    fn held(&self) -> Vec<usize> {
        let all = || self.passages.iter().flat_map(|passage| &passage.segments);
        let sticks = |contact: &usize| all().all(|one| one.modes[*contact] == Mode::Stick);
        (0..self.start.modes.len()).filter(sticks).collect()
    }

    /// The contacts that stick but for brief slides, all of them to the same side.
    pub(super) fn give_way(&self) -> impl Iterator<Item = usize> {
        let share = |contact: usize, mode: Mode| -> f64 {
            let all = self.passages.iter().flat_map(|passage| &passage.segments);
            let such = all.filter(|one| one.modes[contact] == mode);
            such.map(|one| one.duration).sum::<f64>() / self.period
        };
        (0..self.start.modes.len()).filter(move |&contact| {
            let [forward, backward, rest] = [Mode::SlideForward, Mode::SlideBackward, Mode::Stick]
                .map(|mode| share(contact, mode));
            let one_way = forward.min(backward) == 0.0 && forward.max(backward) > 0.0;
            one_way && rest >= 1.0 - BRIEFLY && (forward + backward + rest - 1.0).abs() <= ROUNDING
        })
    }
}

impl OrbitProblem {
    /// Takes what holds one more orbit of a branch; it is refused where that is held no more.
    ///
    /// # Errors
    /// The motion does not close.
    pub(super) fn keep_pinned(&mut self, r: f64, shot: &Shot) -> Result<(), FlowError> {
        let held = shot.held();
        let lets_go = self.held.iter().any(|contact| !held.contains(contact));
        if lets_go && self.slips(r, shot)? {
            return Err(FlowError::LetsGo);
        }
        if self.hardly_slides(r, shot)? {
            return Err(FlowError::LetsGo);
        }
        let closure = shot.closure;
        if !self.pins.is_empty() && closure > (UNCLOSED * self.accuracy).max(CLOSED) {
            return Err(FlowError::Unpinned { closure });
        }
        // What has let go of a pin may move it later only.
        let more = held.iter().filter(|contact| !self.held.contains(contact));
        let more: Vec<usize> = more.copied().collect();
        self.held.extend(more);
        Ok(())
    }

    /// Whether a contact slides, to one side only, by no more than its motion is known: as it comes back to where it was, it does
    /// not slide at all. What it holds puts it next to where it would.
    fn hardly_slides(&self, r: f64, shot: &Shot) -> Result<bool, FlowError> {
        let flow = self.family.at(r)?;
        for contact in shot.give_way() {
            let way = way(&*flow, (&shot.start, shot.period), contact)?;
            let could = self.fastest(&*flow, &shot.start.state, contact) * shot.period;
            if way <= SLIDES * self.accuracy * could {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The most by which a state changes the speed of a contact that moves by its usual magnitude.
    fn fastest(&self, flow: &dyn Flow, state: &[f64], contact: usize) -> f64 {
        let still = flow.speeds(state)[contact];
        let changes = (0..state.len()).map(|j| {
            let mut moved = state.to_vec();
            moved[j] += self.magnitude[j];
            (flow.speeds(&moved)[contact] - still).abs()
        });
        changes.fold(0.0, f64::max)
    }

    /// The same of a motion that cannot even be compared with its beginning.
    pub(super) fn lets_go(&self, why: FlowError) -> FlowError {
        let slides = matches!(why, FlowError::OtherMode { .. });
        match slides && !self.pins.is_empty() && !self.held.is_empty() {
            true => FlowError::LetsGo,
            false => why,
        }
    }

    /// Whether what is held may change once a contact slides, however little it does so yet.
    fn slips(&self, r: f64, shot: &Shot) -> Result<bool, FlowError> {
        let flow = self.family.at(r)?;
        let kept = |pin: &Pin| {
            let holds = if pin.driven { is_driven } else { is_conserved };
            holds(&*flow, &pin.combination, shot, &self.magnitude)
        };
        let mut pins = self.pins.iter().filter(|pin| pin.conserved());
        Ok(!pins.all(kept))
    }
}

/// For which share of its period a contact slides.
pub(super) fn slides(orbit: &Orbit, contact: usize) -> f64 {
    let slides = orbit.segments.iter();
    let slides = slides.filter(|segment| segment.modes[contact] != Mode::Stick);
    slides.map(|segment| segment.duration).sum::<f64>() / orbit.period
}

/// Whether a contact keeps its mode on a passage.
pub(super) fn keeps_mode(passage: &Passage, contact: usize) -> bool {
    let mut own = passage.events.iter().filter(|one| one.contact == contact);
    !own.any(|event| event.switches())
}

/// How far a contact slides in this time from a place on.
///
/// # Errors
/// The motion cannot be followed.
pub(super) fn way(
    flow: &dyn Flow,
    (from, time): (&Place, f64),
    contact: usize,
) -> Result<f64, FlowError> {
    let want = Want {
        panel: time / PANELS,
        ..Want::default()
    };
    let passage = flow.advance(from, time, want)?;
    let way = |node: &Node| node.weight * flow.speeds(&node.state)[contact].abs();
    Ok(passage.nodes.iter().map(way).sum())
}

/// The time after which a motion of about this period is to repeat: the drive turns as often as before.
pub(super) fn once(flow: &dyn Flow, place: &Place, about: f64) -> Option<f64> {
    let Some(phase) = flow.phase() else {
        return Some(about);
    };
    let turn = TAU / flow.velocity(place).ok()?.f[phase];
    Some(turn * (about / turn).round().max(1.0))
}

/// Whether an orbit of about this period is one to which a branch comes.
pub(super) fn reaches(orbit: &Orbit, period: f64) -> bool {
    (orbit.period / period - 1.0).abs() <= REACH
}

/// What is sought next to an orbit.
pub(super) fn near(orbit: &Orbit, accuracy: f64) -> Search {
    Search {
        start: orbit.place.state.clone(),
        modes: orbit.place.modes.clone(),
        period: Some(orbit.period),
        accuracy,
        segments: 1,
    }
}

/// The branch passes to orbits that follow other equations, if they were found, at a point of this kind at r, known with this
/// error.
pub(super) fn passes(
    last: &Orbit,
    (kind, r, error): (Kind, f64, f64),
    beyond: Option<Started<OrbitProblem>>,
    accuracy: f64,
) -> Crossing<OrbitProblem, Orbit> {
    let mut located = Located::at(kind, r, last.clone());
    (located.point.r, located.error) = (r, error + NOISE * accuracy * last.r_size());
    let there = beyond
        .as_ref()
        .and_then(|started| started.0.problem.family.at(r).ok());
    let period = there.and_then(|flow| once(flow.as_ref(), &last.place, last.period));
    located.point.period = period.unwrap_or(last.period);
    let onwards = |started| Beyond::Onwards(Box::new(started));
    Crossing {
        located,
        beyond: beyond.map_or(Beyond::Undecided, onwards),
    }
}
