//! Newton's method of shooting.

use super::anchor::problem;
use super::error::OrbitError;
use super::flat::{EXTENT, at_rest, is_flat};
use super::guess::Guess;
use super::problem::OrbitProblem;
use super::shot::Shot;
use crate::continuation::{Corrected, Failure, ZeroProblem, correct_at};
use crate::integrate::Tolerance;
use crate::motion::Family;

/// Accuracy of the first orbit that is found.
pub(super) const ROUGH: f64 = 1e-7;
/// Accuracy at which it can still be told how often a motion has gone around.
pub(super) const LOOSEST: f64 = 1e-6;
/// How far the motion of a pinned start may be from closing, over the accuracy.
const UNCLOSED: f64 = 1e3;

/// An orbit at one tolerance.
pub(super) type Found = Corrected<Shot>;
/// The same, and the equations that it solves.
pub(super) type Converged = (Found, OrbitProblem);

/// What Newton's method is to reach, and to report.
#[derive(Debug, Clone, Copy)]
pub(super) struct Effort {
    pub(super) accuracy: f64,
    pub(super) tolerance: Tolerance,
    pub(super) factors: bool,
}

/// Shooting with the flow at the tolerance for `effort.tolerance`; refuses an equilibrium.
pub(super) fn newton(
    family: &Family,
    r: f64,
    guess: &Guess,
    segments: usize,
    effort: Effort,
) -> Result<Converged, OrbitError> {
    let family = family
        .with_tolerance(effort.tolerance)
        .with_magnitude(&guess.magnitude);
    let flow = family.at(r)?;
    if at_rest(flow.as_ref(), guess)? {
        return Err(OrbitError::Equilibrium {
            state: flow.values(&guess.place.state).within(guess.shares(EXTENT)),
        });
    }
    let (mut problem, z) = problem(family, r, guess, segments)?;
    problem.want.factors = effort.factors;
    let found = correct_at(&mut problem, z.clone(), r, effort.accuracy);
    let found = found.or_else(|failure| {
        let shot = problem.evaluate(&z, r).map_err(Failure::Evaluation)?.extra;
        let present = problem.division(&z, &shot);
        let division = problem
            .divided(&present, r, &shot, false)
            .map_err(Failure::Evaluation)?;
        let z = problem.divide(&division.ok_or(failure)?);
        correct_at(&mut problem, z, r, effort.accuracy)
    });
    let found = found.map_err(OrbitError::Newton)?;
    let shot = &found.linearisation.extra;
    if !shot.pins.is_empty() && shot.closure > UNCLOSED * effort.accuracy {
        let (motion, errors) = (
            (&*shot.start.state, shot.period),
            guess.shares(effort.accuracy),
        );
        return Err(OrbitError::one_of_many(&*flow, motion, errors));
    }
    if is_flat(shot, &guess.magnitude) {
        let state = flow.values(&shot.start.state);
        return Err(match shot.shift {
            Some(_) => OrbitError::Steady { state },
            None => OrbitError::Equilibrium {
                state: state.within(guess.shares(EXTENT)),
            },
        });
    }
    Ok((found, problem))
}
