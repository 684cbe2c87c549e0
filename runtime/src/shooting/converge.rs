//! From a guess to a converged periodic orbit with an estimate of its error.

use super::anchor::{anchored, once_around};
use super::error::OrbitError;
use super::guess::Guess;
use super::least::{between, shorter};
use super::neutral::{pins, suspect};
use super::newton::{Converged, Effort, Found, LOOSEST, ROUGH, newton};
use super::orbit::{Orbit, Solution};
use super::pin::{through, told};
use super::shot::Shot;
use super::sought::Search;
use crate::continuation::{CLOSED, Failure, ZeroProblem};
use crate::flow::FlowError;
use crate::integrate::Tolerance;
use crate::motion::{Family, NOISE};

/// Local error of a motion in closed form, in units of the last place: the rounding of its terms and of event times. As
/// little as covers what interval arithmetic proves of a drill string next to its fold.
const ROUNDING: f64 = 74.0;
/// Error of a period over the local error below which an agreement of two runs is one by chance.
pub(super) const CHANCE: f64 = 4.0;
/// What is reported over what two runs differ by: they share part of their errors.
pub(super) const DOUBT: f64 = 1.5;
/// Tolerance of the orbit that is reported, over that of the one with which it is compared.
pub(super) const TIGHTER: f64 = 0.1;
/// How often the tolerance is tightened beyond that, and how far off the accuracy the estimate is to be for it.
const TIGHTENINGS: usize = 3;
const SLACK: f64 = 10.0;
/// Error of an orbit of which no digit is known: with a multiplier that may be 1 it is none that stands alone, as where a motion
/// has crept to where friction holds it.
const UNKNOWN: f64 = 1.0;

/// Newton from a guess: on the section if the guess lies there, then to the minimal period, then with
/// a tighter tolerance, which gives the error estimate.
///
/// An orbit that is fast where it crosses its section, or about to switch there, is found from its calmest place.
///
/// # Errors
/// See [`OrbitError`].
pub fn converge(
    family: &Family,
    r: f64,
    guess: &Guess,
    search: &Search,
) -> Result<Orbit, OrbitError> {
    let crossing = from(family, r, guess, search, &anchored);
    match crossing {
        Err(OrbitError::Newton(_)) => calmly(family, r, guess, search).unwrap_or(crossing),
        _ => crossing,
    }
}

/// The orbit from the calmest place on the way of a guess; `None` where that leads to none either.
pub(super) fn calmly(
    family: &Family,
    r: f64,
    guess: &Guess,
    search: &Search,
) -> Option<Result<Orbit, OrbitError>> {
    let calm = calm(family, r, guess, search)?;
    let found = from(family, r, &calm, search, &|family, r, found, usual| {
        let shot = &found.linearisation.extra;
        let (period, magnitude) = once_around(family.at(r)?.as_ref(), shot, usual);
        // What was found to be neutral on the way is held.
        Ok(Guess {
            period,
            magnitude,
            pins: told(&shot.pins, &shot.start.state),
            ..calm.moved(found)
        })
    });
    found.is_ok().then_some(found)
}

/// How far from a guess the orbit is to which it leads, in its start and in its period, or in the calmest place on its way;
/// `None` if it leads to none.
pub(super) fn missed(family: &Family, r: f64, guess: &Guess, search: &Search) -> Option<f64> {
    let accuracy = search.accuracy.clamp(ROUGH, LOOSEST);
    let effort = Effort {
        accuracy,
        tolerance: Tolerance::for_accuracy(accuracy),
        factors: false,
    };
    let off = |guess: &Guess| {
        let (found, _) = newton(family, r, guess, search.segments, effort).ok()?;
        Some(between(&guess.moved(&found), guess))
    };
    off(guess).or_else(|| off(&calm(family, r, guess, search)?))
}

/// The same guess, from the calmest place on its way.
fn calm(family: &Family, r: f64, guess: &Guess, search: &Search) -> Option<Guess> {
    let tolerance = Tolerance::for_accuracy(search.accuracy.max(ROUGH));
    let family = family
        .with_tolerance(tolerance)
        .with_magnitude(&guess.magnitude);
    let flow = family.at(r).ok()?;
    let passage = flow.advance(&guess.place, guess.period, Default::default());
    let place = passage.ok()?.calm.place;
    Some(Guess {
        pins: through(&guess.pins, &place.state),
        place,
        ..guess.clone()
    })
}

/// What makes a guess of a rough orbit at r, given the usual magnitudes of its states.
type Anchor<'a> = dyn Fn(&Family, f64, &Found, &[f64]) -> Result<Guess, FlowError> + 'a;

/// Newton from a guess, thrice; `anchor` makes the second guess of the first, rough, orbit.
pub(super) fn from(
    family: &Family,
    r: f64,
    guess: &Guess,
    search: &Search,
    anchor: &Anchor<'_>,
) -> Result<Orbit, OrbitError> {
    let accuracy = search.accuracy;
    let newton = |guess: &_, accuracy: f64, tolerance: Tolerance, factors: bool| {
        let effort = Effort {
            accuracy,
            tolerance,
            factors,
        };
        newton(family, r, guess, search.segments, effort)
    };
    let fine = Tolerance::for_accuracy(accuracy);
    let factors = family.order() > 2;
    let least = accuracy.clamp(ROUGH, LOOSEST);
    let rough = newton(guess, least, Tolerance::for_accuracy(least), false);
    if guess.pins.is_empty()
        && let Some(pinned) = pinned(family, r, guess, &rough)
    {
        return from(family, r, &pinned, search, anchor);
    }
    let rough = rough?;
    let guess = anchor(family, r, &rough.0, &guess.magnitude)?;
    let mut tolerance = fine;
    let mut loose = newton(&guess, accuracy, tolerance, false);
    for _ in 0..TIGHTENINGS {
        if !loose.as_ref().is_err_and(|error| is_lost(error, accuracy)) {
            break;
        }
        tolerance = tolerance.times(TIGHTER);
        loose = newton(&guess, accuracy, tolerance, false);
    }
    let mut loose = loose?;
    let creeps = loose.0.creeps();
    let mut work = rough.1.work;
    work += loose.1.work;
    tolerance = tolerance.times(TIGHTER);
    let mut tight = newton(&guess.moved(&loose.0), accuracy, tolerance, factors)?;
    work += tight.1.work;
    let mut error = difference(&loose.0, &tight.0, &guess.magnitude);
    let mut blur = between(&guess.moved(&loose.0), &guess.moved(&tight.0));
    // A small error once around is a large one of an orbit that hardly attracts.
    for _ in 0..TIGHTENINGS {
        if error <= SLACK * accuracy {
            break;
        }
        loose = tight;
        tolerance = tolerance.times(TIGHTER);
        let tighter = newton(&guess.moved(&loose.0), accuracy, tolerance, factors);
        let Some(tighter) = tighter
            .ok()
            .filter(|t| difference(&loose.0, &t.0, &guess.magnitude) < error)
        else {
            tight = loose;
            break;
        };
        tight = tighter;
        work += tight.1.work;
        error = difference(&loose.0, &tight.0, &guess.magnitude);
        blur = between(&guess.moved(&loose.0), &guess.moved(&tight.0));
    }
    let (tight, problem) = tight;
    if error > SLACK * accuracy
        && let Some(held) = problem.inside(r, &tight, &guess)?
        && let Ok(held) = from(family, r, &held, search, anchor)
    {
        return Ok(held);
    }
    let long = guess.moved(&tight);
    let flow = family.with_tolerance(fine).with_magnitude(&guess.magnitude);
    let again = |guess: &Guess| Some(newton(guess, accuracy, fine, false).ok()?.0);
    let shot = &tight.linearisation.extra;
    if let Some(least) = shorter(flow.at(r)?.as_ref(), (&long, shot), blur, again)? {
        return from(family, r, &least, search, anchor);
    }
    let solution = Solution {
        shot,
        z: &tight.z,
        r,
        residual: tight.residual,
    };
    let mut orbit = Orbit::read(family, solution.clone(), error, work);
    // What hardly attracts keeps the error of each period: two runs may agree by chance.
    // Two runs in closed form differ by rounding alone, which says little of how large it may be.
    let (local, share) = match problem.work.is_in_closed_form() {
        true => (
            (f64::EPSILON * ROUNDING.max(offset(shot, &guess.magnitude))).max(shot.rounding()),
            CHANCE * CHANCE,
        ),
        false => (tolerance.explicit().relative, 1.0),
    };
    let least = CHANCE * local / orbit.floquet.pull();
    // Extrema are those of the last motion, one correction away from the orbit.
    let last = tight.corrections.last().copied().unwrap_or(0.0);
    orbit.error_estimate = DOUBT * (share * orbit.error_estimate).max(least).max(last);
    if creeps {
        // What passes 1 there does so as the orbit comes to it: it is known to no more than the orbit is.
        orbit = Orbit::read(family, solution, orbit.error_estimate, work);
    }
    let is_known = orbit.error_estimate < UNKNOWN || orbit.floquet.growths.marginal() == 0;
    if !is_known {
        let (motion, errors) = ((&*shot.start.state, shot.period), guess.shares(accuracy));
        return Err(OrbitError::one_of_many(&*flow.at(r)?, motion, errors));
    }
    Ok(orbit)
}

/// Whether Newton's method came so near that what it failed by may be the errors of the motion: those of a copy differ with its
/// steps, and so from one start to the next.
fn is_lost(error: &OrbitError, accuracy: f64) -> bool {
    let OrbitError::Newton(Failure::ResidualRose { before, .. }) = error else {
        return false;
    };
    *before <= CLOSED * accuracy
}

/// How many times as large as it swings a state is.
fn offset(shot: &Shot, magnitude: &[f64]) -> f64 {
    let (low, high) = shot.extent();
    let sizes = low.iter().zip(&high).zip(magnitude);
    let sizes = sizes.map(|((low, high), unit)| low.abs().max(high.abs()) / unit);
    sizes.fold(1.0, f64::max)
}

/// The guess with what singles out its orbit where those beside it are orbits too.
fn pinned(
    family: &Family,
    r: f64,
    guess: &Guess,
    rough: &Result<Converged, OrbitError>,
) -> Option<Guess> {
    let mut pinned = match rough {
        Ok((found, problem)) if suspect(&found.linearisation, &problem.scale()) => {
            guess.moved(found)
        }
        Err(OrbitError::Newton(_)) => guess.clone(),
        _ => return None,
    };
    pinned.pins = pins(family, r, &pinned);
    (!pinned.pins.is_empty()).then_some(pinned)
}

/// Largest relative difference of period and extrema between two computations of one orbit; these are its usual sizes.
fn difference(a: &Found, b: &Found, usual: &[f64]) -> f64 {
    let (first, second) = (&a.linearisation.extra, &b.linearisation.extra);
    let period = (a.z[a.z.len() - 1] / b.z[b.z.len() - 1] - 1.0).abs();
    let ((low_a, high_a), (low_b, high_b)) = (first.extent(), second.extent());
    (0..low_a.len()).fold(period.max(1e-15), |largest, j| {
        let size = match high_b[j].abs().max(low_b[j].abs()) {
            rounding if rounding <= NOISE * usual[j] => usual[j],
            size => size,
        };
        largest
            .max((high_a[j] - high_b[j]).abs() / size)
            .max((low_a[j] - low_b[j]).abs() / size)
    })
}
