//! An orbit that is known already: read off one motion, without a step of Newton's method.
//!
//! At its special points the equations of an orbit are singular by nature, so that a step from a solution leads anywhere.

use super::anchor::problem;
use super::flat::{at_rest, is_flat};
use super::guess::Guess;
use super::orbit::{Orbit, Solution};
use crate::continuation::ZeroProblem;
use crate::motion::Family;

/// The orbit that begins at a guess, if its motion closes to the accuracy; `None` if it does not, or rests.
///
/// Its error is the root of what it lacks: along a critical direction it is known no better.
pub(super) fn closed(
    family: &Family,
    r: f64,
    guess: &Guess,
    (accuracy, segments): (f64, usize),
) -> Option<Orbit> {
    let flow = family.at(r).ok()?;
    if at_rest(flow.as_ref(), guess).ok()? {
        return None;
    }
    let (mut problem, z) = problem(family.clone(), r, guess, segments).ok()?;
    problem.want.factors = family.order() > 2;
    let found = problem.evaluate(&z, r).ok()?;
    let (residual, shot) = (found.residual.norm(), &found.extra);
    if residual > accuracy || is_flat(shot, &guess.magnitude) {
        return None;
    }
    let solution = Solution {
        shot,
        z: &z,
        r,
        residual,
    };
    let error = residual.max(f64::EPSILON).sqrt();
    Some(Orbit::read(family, solution, error, problem.work))
}
