//! Where on its orbit a guess begins: on the section or afloat, with the minimal period.

use nalgebra::{DMatrix, DVector};

use super::division::Division;
use super::guess::Guess;
use super::phase::Phase;
use super::pin::told;
use super::problem::OrbitProblem;
use super::shift::changes_nothing;
use super::shot::Shot;
use crate::continuation::Corrected;
use crate::flow::FlowError;
use crate::motion::{Family, Flow, Place, Velocity, apart};

type Found = Corrected<Shot>;

/// What decays within this share of a period is fast.
const SLOW: f64 = 1e-3;
/// Two points of the section closer than this are one.
pub(super) const SAME_POINT: f64 = 1e-5;

/// The shooting problem near a guess, and its unknowns.
///
/// # Errors
/// The motion cannot be followed to the starts of the segments.
pub(crate) fn problem(
    family: Family,
    r: f64,
    guess: &Guess,
    segments: usize,
) -> Result<(OrbitProblem, DVector<f64>), FlowError> {
    let flow = family.at(r)?;
    let division = match &guess.division {
        Some(division) => division.clone(),
        None => Division::equal(flow.as_ref(), guess.place.clone(), guess.period, segments)?,
    };
    let velocity = flow.velocity(&guess.place)?;
    let phase = phase(flow.phase(), &velocity, guess);
    let z = OrbitProblem::unknowns(&division.starts, guess.period);
    let magnitude = guess.magnitude.clone();
    let mut problem = OrbitProblem::new(family, phase, &division, guess.period, magnitude);
    problem.pins = guess.pins.clone();
    problem.shift.clone_from(&guess.shift);
    Ok((problem, z))
}

/// The phase of the drive; without one, the default section where the guess lies on it and crosses it, else
/// orthogonality to the field.
fn phase(drive: Option<usize>, velocity: &Velocity, guess: &Guess) -> Phase {
    let speed = velocity.f[0].abs() * guess.period / (std::f64::consts::TAU * guess.magnitude[0]);
    let bend = (velocity.jacobian.row(0) * &velocity.f)[0];
    let turn = bend.abs() * (guess.period / std::f64::consts::TAU).powi(2) / guess.magnitude[0];
    if drive.is_none() && speed < 1e-2 * turn && turn > 1e-3 {
        Phase::Section(0)
    } else {
        let state = guess.place.state.clone();
        let velocity = slow(velocity, SLOW * guess.period);
        Phase::floating(drive, state, &velocity, &guess.magnitude)
    }
}

/// f without what decays within the time `step`: (I − hJ)⁻¹ f, the slope of an implicit Euler step.
///
/// On a slow manifold f itself is mostly the error with which the state lies on it.
fn slow(velocity: &Velocity, step: f64) -> DVector<f64> {
    let order = velocity.f.len();
    let matrix = DMatrix::identity(order, order) - &velocity.jacobian * step;
    let slope = matrix.lu().solve(&velocity.f);
    let slope = slope.filter(|slope| slope.iter().all(|component| component.is_finite()));
    slope.unwrap_or_else(|| velocity.f.clone())
}

/// A guess from a converged shot, on the section, with the minimal period; `usual` are the usual sizes of the states.
///
/// # Errors
/// The flow has no place at the section point.
pub fn anchored(family: &Family, r: f64, found: &Found, usual: &[f64]) -> Result<Guess, FlowError> {
    let shot = &found.linearisation.extra;
    let first = shot.minima().next();
    let place = match first {
        Some((time, first)) if first != shot.start.state && shot.passages.len() == 1 => {
            shot.place(family.at(r)?.as_ref(), time, &first)?
        }
        _ => shot.start.clone(),
    };
    let (period, magnitude) = once_around(family.at(r)?.as_ref(), shot, usual);
    Ok(Guess {
        pins: told(&shot.pins, &place.state),
        shift: shot.gain(period),
        division: shot.division(&found.z).filter(|_| period == shot.period),
        place,
        period,
        magnitude,
    })
}

/// The minimal period of a converged shot, and half the extent of each state, or what is usual for one that rests.
///
/// The motion may have gone around several times: the first return that repeats throughout closes it, if what has been gained
/// until then changes nothing.
pub(super) fn once_around(flow: &dyn Flow, shot: &Shot, usual: &[f64]) -> (f64, Vec<f64>) {
    let magnitude = shot.magnitude(usual);
    let minima = shot.points();
    let count = minima.len().max(1);
    let part = |k: usize| shot.period * k as f64 / count as f64;
    let repeats = |k: usize| {
        let same = |i: usize| apart(&minima[i], &minima[(i + k) % count], &magnitude);
        (0..count).all(|i| same(i) < SAME_POINT)
    };
    let whole = |k: usize| {
        let gain = shot.gain(part(k));
        gain.is_none_or(|gain| changes_nothing(flow, &gain, &magnitude))
    };
    let parts = (1..count).filter(|k| count.is_multiple_of(*k));
    let once = parts.filter(|&k| repeats(k)).find(|&k| whole(k));
    (part(once.unwrap_or(count)), magnitude)
}

impl Guess {
    /// The same guess, moved onto a converged orbit.
    pub(super) fn moved(&self, found: &Corrected<Shot>) -> Self {
        let order = self.place.state.len();
        Self {
            place: Place {
                state: found.z.rows(0, order).iter().copied().collect(),
                modes: self.place.modes.clone(),
            },
            period: found.z[found.z.len() - 1],
            magnitude: self.magnitude.clone(),
            pins: self.pins.clone(),
            shift: found.linearisation.extra.shift.clone(),
            division: found.linearisation.extra.division(&found.z),
        }
    }
}
