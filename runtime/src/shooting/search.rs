//! From a start to the periodic orbit that is reached from it.

use super::anchor::anchored;
use super::converge::{TIGHTER, converge, from, missed};
use super::error::OrbitError;
use super::given::closed;
use super::guess::{Guess, magnitude_of};
use super::least::parts;
use super::newton::ROUGH;
use super::offered::{Failed, Meant, swung_about};
use super::orbit::Orbit;
use super::settle::{Settled, settle};
use super::shift::Shifts;
use super::sought::Search;
use crate::flow::{FlowError, Want};
use crate::integrate::Tolerance;
use crate::motion::{Family, Flow, Place, half_extents};

/// Magnitudes are far off if those of the motion are smaller by this factor.
const COARSE: f64 = 1e-3;
/// Accuracy to which it is told whether a motion comes back.
const SHARP: f64 = 1e-9;
/// A motion has come back as near as this to where it was, in half extents, after the period that is given.
const RETURNED: f64 = 0.3;
/// An orbit of a part of the period that is given may be as far as this from its start, in half extents: one that is known to
/// four digits.
const GIVEN: f64 = 1e-4;
/// Finds the periodic orbit of `family` at r that is reached from `search.start`: the first to which a return of the
/// motion leads, be it stable or not.
///
/// # Errors
/// See [`OrbitError`].
pub fn closest(family: &Family, r: f64, search: &Search) -> Result<Orbit, OrbitError> {
    find(family, r, search, Meant::First)
}

/// Finds the periodic orbit of `family` at r on which the motion from `search.start` settles, of whatever period; an
/// unstable one only if the motion begins on it.
///
/// # Errors
/// See [`OrbitError`].
pub fn settled(family: &Family, r: f64, search: &Search) -> Result<Orbit, OrbitError> {
    find(family, r, search, Meant::Last)
}

/// The periodic orbit of `family` at r next to `search.start`, to which a motion comes back after `period`, if the motion is
/// drawn to it: one look at one return.
///
/// # Errors
/// See [`OrbitError`].
pub fn drawn(family: &Family, r: f64, search: &Search, period: f64) -> Result<Orbit, OrbitError> {
    let guess = given(family, r, search, period)?;
    let orbit = from(family, r, &guess, search, &anchored)
        .or_else(|error| swung_about(family, r, &guess, search).ok_or(error))?;
    let magnitude = half_extents(&orbit.min, &orbit.max, &guess.magnitude);
    let guess = Guess { magnitude, ..guess };
    Failed::new(Meant::Last).taken(family, r, &guess, (orbit, search))
}

fn find(family: &Family, r: f64, search: &Search, meant: Meant) -> Result<Orbit, OrbitError> {
    if let Some(period) = search.period {
        return near(family, r, &given(family, r, search, period)?, search);
    }
    let magnitude = magnitude_of(&search.start);
    let loose = |magnitude: &[f64]| loose(family, magnitude).at(r);
    let flow = loose(&magnitude)?;
    let start = flow.place_in(&search.start, &search.modes)?;
    let mut failed = Failed::new(meant);
    let longest = meant.longest();
    let mut settled = settle(flow.as_ref(), start.clone(), longest, |guess| {
        failed.unless(family, r, guess, search)
    })?;
    // What a start shows of the magnitudes may be far off: then all this was integrated too coarsely.
    if let (Settled::Neither(..), Some(seen)) = (&settled, &failed.magnitude.take())
        && (0..seen.len()).any(|j| seen[j] < COARSE * magnitude[j])
    {
        failed = Failed::new(meant);
        settled = settle(loose(seen)?.as_ref(), start, longest, |guess| {
            failed.unless(family, r, guess, search)
        })?;
    }
    match settled {
        Settled::Orbit(orbit) => orbit,
        Settled::Equilibrium(state, errors) => Err(OrbitError::Equilibrium {
            state: flow.values(&state).within(errors),
        }),
        Settled::Neither(time, place) => {
            let last = failed.last.map(Box::new);
            failed.doubtful.ok_or(OrbitError::NotSettled {
                time,
                last,
                reached: place.state,
                exponent: None,
            })
        }
    }
}

/// The flows that a search follows.
fn loose(family: &Family, magnitude: &[f64]) -> Family {
    let rough = family.with_tolerance(Tolerance::for_accuracy(ROUGH));
    rough.with_magnitude(magnitude)
}

/// A guess of the period that is given.
fn given(family: &Family, r: f64, search: &Search, period: f64) -> Result<Guess, FlowError> {
    let magnitude = magnitude_of(&search.start);
    let flow = loose(family, &magnitude).at(r)?;
    let place = flow.place_in(&search.start, &search.modes)?;
    Ok(Guess {
        shift: gained(flow.as_ref(), &place, period, &magnitude)?,
        place,
        period,
        magnitude,
        pins: Vec::new(),
        division: None,
    })
}

/// What the states gain in a period given, if it is little more than a shift that changes nothing.
fn gained(
    flow: &dyn Flow,
    start: &Place,
    period: f64,
    magnitude: &[f64],
) -> Result<Option<Vec<f64>>, FlowError> {
    let shifts = Shifts::of(flow, magnitude);
    if shifts.is_empty() {
        return Ok(None);
    }
    let passage = flow.advance(start, period, Want::default())?;
    let units = half_extents(&passage.calm.low, &passage.calm.high, magnitude);
    let ends = [start.state.as_slice(), &passage.end.state];
    Ok(shifts.within(ends, &units, RETURNED))
}

/// The orbit near a guess with a period, which may go around it several times: so often that the motion leaves it in the
/// end, if it is unstable. Then one of a part of the period is it only if it passes through the start that is given: near a
/// long orbit that cannot be found there are short ones.
fn near(family: &Family, r: f64, guess: &Guess, search: &Search) -> Result<Orbit, OrbitError> {
    let sharp = Tolerance::for_accuracy(search.accuracy.min(SHARP));
    let flow = family
        .with_tolerance(sharp)
        .with_magnitude(&guess.magnitude);
    let [sure, others] = parts(flow.at(r)?.as_ref(), guess).unwrap_or_default();
    let orbit = |part: &Guess| converge(family, r, part, search).ok();
    let passes = |part: &&Guess| missed(family, r, part, search).is_some_and(|off| off <= GIVEN);
    match sure.iter().find_map(orbit) {
        Some(orbit) => Ok(orbit),
        None => converge(family, r, guess, search)
            .or_else(|error| special(family, r, guess, search).ok_or(error))
            .or_else(|error| others.iter().filter(passes).find_map(orbit).ok_or(error)),
    }
}

/// The orbit that is given, if it closes as it is, as one that was saved at a special point of its branch does.
fn special(family: &Family, r: f64, guess: &Guess, search: &Search) -> Option<Orbit> {
    let asked = (search.accuracy, search.segments);
    let sharp = family.with_tolerance(Tolerance::for_accuracy(search.accuracy).times(TIGHTER));
    let known = sharp.with_magnitude(&guess.magnitude);
    let orbit = closed(&known, r, guess, asked)?;
    let magnitude = half_extents(&orbit.min, &orbit.max, &guess.magnitude);
    let known = sharp.with_magnitude(&magnitude);
    let guess = Guess {
        magnitude,
        ..guess.clone()
    };
    closed(&known, r, &guess, asked)
}
