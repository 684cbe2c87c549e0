//! Further orbits: Newton's method on equations of which orbits that are known are no solutions any more.
//!
//! The equations h of shooting are multiplied by D(x) = Π (1/|x − xᵢ|² + 1) over the starts xᵢ at which they are solved
//! already (Farrell, Birkisson, Funke 2015, SIAM J. Sci. Comput. 37, A2026). Where δ is a step of Newton's method for h, that
//! for D h is δ/(1 − ∇ln D · δ): the same direction, gone further or back.
//!
//! An orbit solves the equations wherever it crosses the plane in which starts are sought. Such a start becomes known once
//! Newton's method comes to it, and the seed is then tried again.

use nalgebra::DVector;

use super::anchor::problem;
use super::converge::converge;
use super::guess::Guess;
use super::newton::ROUGH;
use super::orbit::Orbit;
use super::problem::OrbitProblem;
use super::same::SAME_ORBIT;
use super::sought::Search;
use crate::continuation::{ZeroProblem, correct_at};
use crate::integrate::Tolerance;
use crate::motion::Family;

/// Most solutions to which one seed leads.
const SOLUTIONS: usize = 8;
/// Most steps to one of them.
const STEPS: usize = 60;
/// A step, relative to the usual sizes of the unknowns, is no longer than this.
const LONGEST: f64 = 0.3;
/// A step of Newton's method for h this short leads to a solution.
const NEAR: f64 = 1e-3;
/// How often a step that leads to where nothing can be evaluated is halved.
const HALVINGS: usize = 6;
/// Starts nearer to one that is known are that one.
const SAME: f64 = 1e-4;

/// The orbits of `family` at r to which Newton's method leads from `seeds` and that are none of those `known`, each once; a
/// seed keeps the modes in which it begins.
#[must_use]
pub fn further(
    family: &Family,
    r: f64,
    seeds: &[Guess],
    search: &Search,
    known: &[Orbit],
) -> Vec<Orbit> {
    let mut found: Vec<Orbit> = Vec::new();
    for seed in seeds {
        let starts = known.iter().chain(&found).flat_map(Orbit::starts);
        let mut taken: Vec<Vec<f64>> = starts.collect();
        for _ in 0..SOLUTIONS {
            let Some(guess) = deflated(family, r, seed, &taken) else {
                break;
            };
            taken.push(guess.place.state.clone());
            // What is no orbit, a state of rest perhaps, is known from now on, too.
            let Ok(orbit) = converge(family, r, &guess, search) else {
                continue;
            };
            let mut all = known.iter().chain(&found);
            if !all.any(|one| one.coincides(&orbit, SAME_ORBIT)) {
                taken.extend(orbit.starts());
                found.push(orbit);
            }
        }
    }
    found
}

impl Orbit {
    /// The states at which it can begin on its section.
    fn starts(&self) -> impl Iterator<Item = Vec<f64>> + '_ {
        self.section.iter().chain([&self.place.state]).cloned()
    }
}

/// The solution to which a seed leads that begins at none of the states that are taken.
fn deflated(family: &Family, r: f64, seed: &Guess, taken: &[Vec<f64>]) -> Option<Guess> {
    let family = family
        .with_tolerance(Tolerance::for_accuracy(ROUGH))
        .with_magnitude(&seed.magnitude);
    let (mut problem, mut z) = problem(family, r, seed, 1).ok()?;
    let mut at = problem.evaluate(&z, r).ok()?;
    for _ in 0..STEPS {
        let scale = problem.scale();
        let plain = at.scaled(&scale).lu().solve(&-&at.residual)?;
        if !plain.norm().is_finite() {
            return None;
        }
        if plain.norm() <= NEAR {
            return solved(&mut problem, z, r, (seed, taken));
        }
        let share = 1.0 / (1.0 - slope(&z, &plain, &seed.magnitude, taken));
        let mut step = plain * share;
        let length = step.norm();
        if !length.is_finite() {
            return None;
        }
        step *= (LONGEST / length).min(1.0);
        (z, at) = (0..=HALVINGS).find_map(|k| {
            let trial = &z + step.component_mul(&scale) * 0.5_f64.powi(k as i32);
            Some((trial.clone(), problem.evaluate(&trial, r).ok()?))
        })?;
    }
    None
}

/// The solution beside these unknowns, unless it is taken.
fn solved(
    problem: &mut OrbitProblem,
    z: DVector<f64>,
    r: f64,
    (seed, taken): (&Guess, &[Vec<f64>]),
) -> Option<Guess> {
    let found = correct_at(problem, z, r, ROUGH).ok()?;
    let guess = seed.moved(&found);
    let away = |state: &Vec<f64>| square(&guess.place.state, state, &seed.magnitude) > SAME * SAME;
    taken.iter().all(away).then_some(guess)
}

/// ∇ln D · δ: each factor 1/s + 1, s = |x − xᵢ|², has the part −∇s·δ/(s(1 + s)).
fn slope(z: &DVector<f64>, step: &DVector<f64>, magnitude: &[f64], taken: &[Vec<f64>]) -> f64 {
    let part = |state: &Vec<f64>| {
        let s = square(z.as_slice(), state, magnitude).max(f64::MIN_POSITIVE);
        let along = |j: usize| 2.0 * (z[j] - state[j]) / magnitude[j] * step[j];
        let turn: f64 = (0..state.len()).map(along).sum();
        -turn / (s * (1.0 + s))
    };
    taken.iter().map(part).sum()
}

/// The square of the distance of two states, in usual sizes.
fn square(a: &[f64], b: &[f64], magnitude: &[f64]) -> f64 {
    let pairs = b.iter().zip(a).zip(magnitude);
    pairs.map(|((b, a), unit)| ((a - b) / unit).powi(2)).sum()
}
