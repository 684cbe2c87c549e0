//! The least period: whether an orbit goes around a shorter one several times.
//!
//! Points of an orbit that attracts or repels hardly are known far worse than its equations are solved, and those of one
//! lap may differ from those of the next by that. So nothing is concluded from how near they are: a shorter orbit must
//! converge by itself, and then lie where the long one does, as well as that is known.

use super::anchor::SAME_POINT;
use super::guess::Guess;
use super::shot::Shot;
use crate::continuation::Corrected;
use crate::flow::FlowError;
use crate::motion::{Flow, Place, apart, half_extents};

/// Laps that are looked for; a multiple of several of them is found in steps.
const LAPS: [u32; 11] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31];
/// A motion that is further than this from its start has not come back, in half extents.
const NEAR: f64 = 0.05;
/// Parts of a period that are tried where the whole leads nowhere, and how near to its start a motion comes after one.
const PARTS: u32 = 12;
const BACK: f64 = 1e-3;
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
    for laps in LAPS {
        let period = orbit.period / f64::from(laps);
        let place = along(flow, shot, period)?;
        if gap(flow, &place.state, orbit) > NEAR {
            continue;
        }
        let guess = Guess {
            period,
            ..orbit.clone()
        };
        let Some(found) = converge(&guess) else {
            continue;
        };
        let found = guess.moved(&found);
        if between(&found, &guess) <= SAME_POINT.max(BLUR * blur) {
            return Ok(Some(found));
        }
    }
    Ok(None)
}

/// Guesses of a part of a period, the shortest first, where the motion comes back after it: what is left to try where it
/// cannot be followed for the whole as well as Newton's method needs it.
///
/// # Errors
/// The motion cannot be followed.
pub(super) fn parts(flow: &dyn Flow, guess: &Guess) -> Result<Vec<Guess>, FlowError> {
    let whole = flow.advance(&guess.place, guess.period, Default::default())?;
    let magnitude = half_extents(&whole.calm.low, &whole.calm.high, &guess.magnitude);
    let (mut place, mut time) = (guess.place.clone(), 0.0);
    let mut found = Vec::new();
    for laps in (2..=PARTS).rev() {
        let part = Guess {
            period: guess.period / f64::from(laps),
            magnitude: magnitude.clone(),
            ..guess.clone()
        };
        place = flow
            .advance(&place, part.period - time, Default::default())?
            .end;
        time = part.period;
        if gap(flow, &place.state, &part) <= BACK {
            found.push(part);
        }
    }
    Ok(found)
}

/// The place of a shot at a time.
fn along(flow: &dyn Flow, shot: &Shot, time: f64) -> Result<Place, FlowError> {
    let share = shot.period / shot.passages.len().max(1) as f64;
    let before = (time / share) as usize;
    let ends = shot.passages.iter().map(|passage| &passage.end);
    let from = std::iter::once(&shot.start).chain(ends).nth(before);
    let rest = (time - before as f64 * share).max(0.0);
    let passage = flow.advance(from.unwrap_or(&shot.start), rest, Default::default());
    Ok(passage?.end)
}

/// How far a state is from the start of an orbit, but for the phase of a drive.
fn gap(flow: &dyn Flow, state: &[f64], orbit: &Guess) -> f64 {
    let mut state = state.to_vec();
    if let Some(phase) = flow.phase() {
        state[phase] = orbit.place.state[phase];
    }
    apart(&state, &orbit.place.state, &orbit.magnitude)
}
