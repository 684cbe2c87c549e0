//! An orbit from further away than Newton's method reaches.

use super::anchor::{anchored, problem};
use super::converge::from;
use super::guess::Guess;
use super::newton::{LOOSEST, ROUGH};
use super::orbit::Orbit;
use super::sought::Search;
use crate::bifurcation::Stability;
use crate::continuation::{approach, correct_at};
use crate::integrate::Tolerance;
use crate::motion::Family;

/// The stable orbit to which damped steps of Newton's method lead from a guess; `None` where they lead to none that is alone.
///
/// A long step changes when contacts switch, and with that what fast motions are like at its end: the residual rises in them.
/// Of a motion that repeats nowhere, it is arbitrary to which of many unstable orbits they would lead.
pub(super) fn damped(family: &Family, r: f64, guess: &Guess, search: &Search) -> Option<Orbit> {
    let guess = nearer(family, r, guess, search)?;
    let orbit = from(family, r, &guess, search, &anchored).ok()?;
    let attracts = orbit.floquet.stability == Stability::Stable;
    (attracts && orbit.pins.is_empty()).then_some(orbit)
}

/// A guess from which Newton's method converges, as far as is told.
fn nearer(family: &Family, r: f64, guess: &Guess, search: &Search) -> Option<Guess> {
    let tolerance = Tolerance::for_accuracy(search.accuracy.clamp(ROUGH, LOOSEST));
    let family = family
        .with_tolerance(tolerance)
        .with_magnitude(&guess.magnitude);
    let (mut problem, z) = problem(family, r, guess, search.segments).ok()?;
    let z = approach(&mut problem, z, r)?;
    let found = correct_at(&mut problem, z, r, f64::INFINITY).ok()?;
    Some(guess.moved(&found))
}
