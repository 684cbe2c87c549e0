//! Contacts that stick all along an orbit: what friction holds in one place, until it lets go.

use std::f64::consts::TAU;

use super::conserved::is_conserved;
use super::orbit::Orbit;
use super::pin::Pin;
use super::problem::OrbitProblem;
use super::shot::Shot;
use super::sought::Search;
use crate::continuation::{Beyond, Crossing, Kind, Located, Started};
use crate::field::exact::Mode;
use crate::flow::FlowError;
use crate::motion::{Flow, Place};

/// A pinned orbit that closes no better than this is none; or than this over the accuracy, where that is loose.
const CLOSED: f64 = 1e-5;
const UNCLOSED: f64 = 100.0;
/// Relative change of the period up to which an orbit is that to which a branch comes where a contact begins to slide, or
/// ceases to: what slides has hardly an extent, by which orbits could be compared.
const REACH: f64 = 1e-2;
/// What the errors of three orbits may add up to, over one of them.
const NOISE: f64 = 10.0;

impl Shot {
    /// The contacts that stick all along.
    fn held(&self) -> Vec<usize> {
        let all = || self.passages.iter().flat_map(|passage| &passage.segments);
        let sticks = |contact: &usize| all().all(|one| one.modes[*contact] == Mode::Stick);
        (0..self.start.modes.len()).filter(sticks).collect()
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
        let kept = |pin: &Pin| is_conserved(&*flow, &pin.combination, shot, &self.magnitude);
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
    (located.point.r, located.error) = (r, error + NOISE * accuracy * r.abs());
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
