//! The least period: whether an orbit goes around a shorter one several times.
//!
//! Points of an orbit that attracts or repels hardly are known far worse than its equations are solved, and those of one
//! lap may differ from those of the next by that. So nothing is concluded from how near they are: a shorter orbit must
//! converge by itself, and then lie where the long one does, as well as that is known.

use std::f64::consts::TAU;

use super::anchor::SAME_POINT;
use super::guess::Guess;
use super::shift::changes_nothing;
use super::shot::Shot;
use crate::continuation::Corrected;
use crate::flow::FlowError;
use crate::motion::{Flow, Place, apart, half_extents};

/// Laps that are looked for; a multiple of several of them is found in steps.
const LAPS: [u32; 11] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31];
/// A motion that is further than this from its start has not come back, in half extents.
const NEAR: f64 = 0.05;
/// Parts of a period that are looked at.
const PARTS: u32 = 12;
/// How near to its start a motion comes back once around an orbit that it is to go around several times, and how much worse
/// than after the whole period it may be.
const BACK: f64 = 1e-3;
const WORSE: f64 = 10.0;
/// Share of a turn of the drive by which a return may be off.
const TURN: f64 = 1e-3;
/// How many times as far as two runs a shorter orbit may be from the long one.
const BLUR: f64 = 10.0;

/// How far two solutions are apart: in their starts, in half extents, and in their periods.
pub(super) fn between(a: &Guess, b: &Guess) -> f64 {
    let periods = (a.period / b.period - 1.0).abs();
    apart(&a.place.state, &b.place.state, &b.magnitude).max(periods)
}

/// The shorter orbit that this one goes around, if there is one; `blur` is how well it is known, and `converge` finds an
/// orbit near a guess.
///
/// # Errors
/// The motion cannot be followed.
pub(super) fn shorter(
    flow: &dyn Flow,
    (orbit, shot): (&Guess, &Shot),
    blur: f64,
    converge: impl Fn(&Guess) -> Option<Corrected<Shot>>,
) -> Result<Option<Guess>, FlowError> {
    for (guess, place) in returns(flow, orbit, shot)? {
        let back = gap(flow, &place.state, &guess);
        if back > NEAR {
            continue;
        }
        let Some(found) = converge(&guess) else {
            continue;
        };
        let found = guess.moved(&found);
        // A doubled orbit is nearer to the one that it doubles than its halves are to each other.
        if back.max(between(&found, &guess)) <= SAME_POINT.max(BLUR * blur) {
            return Ok(Some(found));
        }
    }
    Ok(None)
}

/// The parts of an orbit after each of which it may be that of a shorter one, and where it is by then.
fn returns(flow: &dyn Flow, orbit: &Guess, shot: &Shot) -> Result<Vec<(Guess, Place)>, FlowError> {
    let parts = LAPS.map(|laps| orbit.part(laps)).into_iter();
    let mut found: Vec<(Guess, Place)> = Vec::new();
    // The shortest first: from the end of one to that of the next.
    for part in parts.filter(|part| part.is_whole(flow)).rev() {
        let last = found.last();
        let reached = last.map(|(before, place)| (place, before.period));
        let place = along(flow, shot, reached, part.period)?;
        found.push((part, place));
    }
    found.reverse();
    Ok(found)
}

/// Guesses of a part of a period after which the motion comes back as well as after the whole, the shortest first: so near
/// that the orbit is sure to be gone around several times, and farther away. Where it comes back far better after the whole,
/// as on a doubled orbit next to its flip, its parts are other orbits.
///
/// # Errors
/// The motion cannot be followed.
pub(super) fn parts(flow: &dyn Flow, guess: &Guess) -> Result<[Vec<Guess>; 2], FlowError> {
    let whole = flow.advance(&guess.place, guess.period, Default::default())?;
    let magnitude = half_extents(&whole.calm.low, &whole.calm.high, &guess.magnitude);
    let wide = Guess {
        magnitude,
        ..guess.clone()
    };
    let closed = gap(flow, &whole.end.state, &wide);
    let (mut place, mut time) = (guess.place.clone(), 0.0);
    let mut found = [Vec::new(), Vec::new()];
    for part in (2..=PARTS).rev().map(|laps| wide.part(laps)) {
        place = flow
            .advance(&place, part.period - time, Default::default())?
            .end;
        time = part.period;
        let back = gap(flow, &place.state, &part);
        if back <= NEAR.min(WORSE * closed) && part.is_whole(flow) {
            found[usize::from(back > BACK)].push(part);
        }
    }
    Ok(found)
}

/// Half way between two turns of a motion that comes back after both but swings to and fro between them, as it does for long
/// where a multiplier is next to -1: a guess of the orbit about which it swings. Around that twice, where the motion comes
/// back well, Newton's matrix is next to singular.
///
/// # Errors
/// The motion cannot be followed.
pub(super) fn midway(flow: &dyn Flow, guess: &Guess) -> Result<Option<Guess>, FlowError> {
    let half = guess.part(2);
    let turned = flow
        .advance(&half.place, half.period, Default::default())?
        .end;
    if !gap(flow, &turned.state, &half).is_finite() || !half.is_whole(flow) {
        return Ok(None);
    }
    let gained = |j: usize| half.shift.as_ref().map_or(0.0, |shift| shift[j]);
    let mut state = half.place.state.clone();
    for j in (0..state.len()).filter(|j| flow.phase() != Some(*j)) {
        state[j] = 0.5 * (state[j] + turned.state[j] - gained(j));
    }
    let modes = (turned.modes == half.place.modes).then_some(&turned.modes);
    let place = Place::known(flow, &state, modes)?;
    Ok(Some(Guess { place, ..half }))
}

impl Guess {
    /// The same guess, once around of so many times.
    pub(crate) fn part(&self, laps: u32) -> Self {
        Self {
            period: self.period / f64::from(laps),
            shift: self.shift.as_ref().map(|shift| {
                let share = |gain: &f64| gain / f64::from(laps);
                shift.iter().map(share).collect()
            }),
            ..self.clone()
        }
    }

    /// Whether what it gains changes nothing: half a turn of an angle is none, where a motion that turns evenly comes back as
    /// well but for that.
    fn is_whole(&self, flow: &dyn Flow) -> bool {
        let shift = self.shift.as_ref();
        shift.is_none_or(|shift| changes_nothing(flow, shift, &self.magnitude))
    }
}

/// The place of a shot at a time, from where it was `reached` at another one before, or from the beginning of its segment.
fn along(
    flow: &dyn Flow,
    shot: &Shot,
    reached: Option<(&Place, f64)>,
    time: f64,
) -> Result<Place, FlowError> {
    let segment = shot.segment(time);
    let begin = shot.begins[segment];
    let ends = shot.passages.iter().map(|passage| &passage.end);
    let start = std::iter::once(&shot.start).chain(ends).nth(segment);
    let start = (start.unwrap_or(&shot.start), begin);
    let (from, passed) = reached.filter(|(_, at)| *at >= begin).unwrap_or(start);
    let rest = (time - passed).max(0.0);
    Ok(flow.advance(from, rest, Default::default())?.end)
}

/// How far the end of an orbit is from its start; out of reach where a drive is at another phase.
fn gap(flow: &dyn Flow, state: &[f64], orbit: &Guess) -> f64 {
    let mut state = state.to_vec();
    if let Some(phase) = flow.phase() {
        let turns = (state[phase] - orbit.place.state[phase]) / TAU;
        if (turns - turns.round()).abs() > TURN {
            return f64::INFINITY;
        }
        state[phase] = orbit.place.state[phase];
    }
    for (y, gain) in state.iter_mut().zip(orbit.shift.iter().flatten()) {
        *y -= gain;
    }
    apart(&state, &orbit.place.state, &orbit.magnitude)
}
