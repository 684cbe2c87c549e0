//! From a start to the periodic orbit that is reached from it.

use super::anchor::anchored;
use super::converge::{TIGHTER, calmly, converge, from, missed};
use super::damped::damped;
use super::error::OrbitError;
use super::given::closed;
use super::guess::{Guess, magnitude_of};
use super::least::{midway, parts};
use super::neutral::neutral;
use super::newton::ROUGH;
use super::orbit::Orbit;
use super::settle::{Settled, settle};
use super::shift::Shifts;
use super::sought::Search;
use super::stay::stays;
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
/// Returns that are all looked at; of later ones every eighth.
const OFTEN: usize = 64;
const SELDOM: usize = 8;

/// Which orbit is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Meant {
    /// The first to which a return leads.
    First,
    /// That on which the motion stays.
    Last,
}

impl Meant {
    /// Longest period sought, in crossings of the section.
    const fn longest(self) -> usize {
        match self {
            Self::First => 32,
            Self::Last => 512,
        }
    }
}

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
    let orbit = from(family, r, &guess, search, anchored)
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
        Settled::Neither(time, place) => Err(OrbitError::NotSettled {
            time,
            last: failed.last.map(Box::new),
            reached: place.state,
            exponent: None,
        }),
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

/// The orbit about which a motion swings to and fro that comes back after two turns.
fn swung_about(family: &Family, r: f64, guess: &Guess, search: &Search) -> Option<Orbit> {
    let flow = family.with_magnitude(&guess.magnitude).at(r).ok()?;
    let midway = midway(flow.as_ref(), guess).ok()??;
    from(family, r, &midway, search, anchored).ok()
}

/// Returns of a motion that were no orbits, or not the one that is meant.
struct Failed {
    meant: Meant,
    count: usize,
    last: Option<OrbitError>,
    magnitude: Option<Vec<f64>>,
}

impl Failed {
    fn new(meant: Meant) -> Self {
        Self {
            meant,
            count: 0,
            last: None,
            magnitude: None,
        }
    }

    /// The orbit, unless another is meant.
    fn taken(
        &self,
        family: &Family,
        r: f64,
        guess: &Guess,
        (orbit, search): (Orbit, &Search),
    ) -> Result<Orbit, OrbitError> {
        if self.meant == Meant::First || stays(family, r, guess, (&orbit, &search.start))? {
            return Ok(orbit);
        }
        Err(OrbitError::Passed {
            period: orbit.period,
            stability: orbit.floquet.stability.name(),
        })
    }

    /// The orbit near a return; `None` if it is no orbit either.
    ///
    /// Of many returns that lead nowhere only the first, second, fourth and so on are looked at closely.
    fn unless(
        &mut self,
        family: &Family,
        r: f64,
        guess: &Guess,
        search: &Search,
    ) -> Option<Result<Orbit, OrbitError>> {
        if self.count > OFTEN && !self.count.is_multiple_of(SELDOM) {
            self.count += 1;
            return None;
        }
        let orbit = from(family, r, guess, search, anchored);
        let error = match orbit.and_then(|orbit| self.taken(family, r, guess, (orbit, search))) {
            Ok(orbit) => return Some(Ok(orbit)),
            Err(error) => error,
        };
        self.count += 1;
        self.magnitude = Some(guess.magnitude.clone());
        // What runs on always has neighbours: they are shifted.
        let runs = guess.shift.is_some();
        if self.count == 1
            && !runs
            && let Some(error) = of_a_family(family, r, guess, search)
        {
            return Some(Err(error));
        }
        let newton = matches!(error, OrbitError::Newton(_));
        // An orbit on which the motion does not stay says more than one that was not reached.
        let passed = matches!(self.last, Some(OrbitError::Passed { .. }));
        if !(passed && newton) {
            self.last = Some(error);
        }
        if !(newton && self.count.is_power_of_two()) {
            return None;
        }
        let taken = |orbit| self.taken(family, r, guess, (orbit, search)).ok();
        let calm = calmly(family, r, guess, search).and_then(Result::ok);
        let drawn = |orbit: &_| stays(family, r, guess, (orbit, &search.start)).unwrap_or(false);
        let other = || swung_about(family, r, guess, search).filter(drawn);
        let damped = || damped(family, r, guess, search).and_then(taken);
        let found = calm.and_then(taken).or_else(damped).or_else(other).map(Ok);
        let one_of_many =
            || (runs && self.count == 1).then(|| of_a_family(family, r, guess, search));
        found.or_else(|| one_of_many().flatten().map(Err))
    }
}

/// That orbits beside this return are as good.
fn of_a_family(family: &Family, r: f64, guess: &Guess, search: &Search) -> Option<OrbitError> {
    let one = neutral(family, r, guess)?;
    let flow = family.at(r).ok()?;
    Some(OrbitError::NotIsolated {
        state: flow
            .values(&one.place.state)
            .within(guess.shares(search.accuracy)),
        period: one.period,
    })
}
