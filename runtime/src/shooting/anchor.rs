//! Where on its orbit a guess begins: on the section or afloat, with the minimal period.

use nalgebra::{DMatrix, DVector};

use super::guess::Guess;
use super::phase::Phase;
use super::problem::{OrbitProblem, Shot, half_extents};
use crate::continuation::Corrected;
use crate::flow::{Family, Flow, FlowError, Place, Velocity};

type Mode<F, const N: usize> = <<F as Family<N>>::Flow as Flow<N>>::Mode;
type Found<F, const N: usize> = Corrected<Shot<N, Mode<F, N>>>;

/// What decays within this share of a period is fast.
const SLOW: f64 = 1e-3;
/// Two points of the section closer than this are one.
const SAME_POINT: f64 = 1e-5;

/// The shooting problem near a guess, and its unknowns.
///
/// # Errors
/// The motion cannot be followed to the starts of the segments.
pub(crate) fn problem<F: Family<N> + Clone, const N: usize>(
    family: F,
    r: f64,
    guess: &Guess<N, Mode<F, N>>,
    segments: usize,
) -> Result<(OrbitProblem<F, N>, DVector<f64>), FlowError> {
    let flow = family.at(r)?;
    let segments = segments.max(1);
    let mut places = vec![guess.place];
    while places.len() < segments {
        let from = places[places.len() - 1];
        places.push(
            flow.advance(&from, guess.period / segments as f64, Default::default())?
                .end,
        );
    }
    let velocity = flow.velocity(&guess.place)?;
    let phase = phase(F::Flow::PHASE, &guess.place.state, &velocity, guess);
    let states: Vec<[f64; N]> = places.iter().map(|place| place.state).collect();
    let z = OrbitProblem::<F, N>::unknowns(&states, guess.period);
    Ok((
        OrbitProblem::new(family, phase, &places, guess.period, guess.magnitude),
        z,
    ))
}

/// The phase of the drive; without one, the default section where the guess lies on it and crosses it, else
/// orthogonality to the field.
fn phase<const N: usize, M>(
    drive: Option<usize>,
    state: &[f64; N],
    velocity: &Velocity<N>,
    guess: &Guess<N, M>,
) -> Phase<N> {
    let speed = velocity.f[0].abs() * guess.period / (std::f64::consts::TAU * guess.magnitude[0]);
    let bend: f64 = (0..N)
        .map(|j| velocity.jacobian[0][j] * velocity.f[j])
        .sum();
    let turn = bend.abs() * (guess.period / std::f64::consts::TAU).powi(2) / guess.magnitude[0];
    if drive.is_none() && speed < 1e-2 * turn && turn > 1e-3 {
        Phase::Section(0)
    } else {
        Phase::floating(drive, *state, slow(velocity, SLOW * guess.period))
    }
}

/// f without what decays within the time `step`: (I − hJ)⁻¹ f, the slope of an implicit Euler step.
///
/// On a slow manifold f itself is mostly the error with which the state lies on it.
fn slow<const N: usize>(velocity: &Velocity<N>, step: f64) -> [f64; N] {
    let matrix = DMatrix::from_fn(N, N, |i, j| {
        f64::from(i == j) - step * velocity.jacobian[i][j]
    });
    let slope = matrix.lu().solve(&DVector::from_column_slice(&velocity.f));
    let slope = slope.filter(|slope| slope.iter().all(|component| component.is_finite()));
    slope.map_or(velocity.f, |slope| std::array::from_fn(|j| slope[j]))
}

/// A guess from a converged shot: on the section, with the minimal period.
///
/// # Errors
/// The flow has no place at the section point.
pub fn anchored<F: Family<N> + Clone, const N: usize>(
    family: &F,
    r: f64,
    found: &Found<F, N>,
) -> Result<Guess<N, Mode<F, N>>, FlowError> {
    let shot = &found.linearisation.extra;
    let first = shot.minima().next();
    let place = match first {
        Some((_, first)) if first != shot.start.state => family.at(r)?.place(first)?,
        _ => shot.start,
    };
    let (period, magnitude) = once_around(shot);
    Ok(Guess {
        place,
        period,
        magnitude,
    })
}

/// The minimal period of a converged shot, and half the extent of each state.
///
/// The motion may have gone around several times: the first return that repeats throughout closes it.
pub(super) fn once_around<const N: usize, M: Copy>(shot: &Shot<N, M>) -> (f64, [f64; N]) {
    let (low, high) = shot.extent();
    let magnitude = half_extents(&low, &high, &[1.0; N]);
    let minima: Vec<[f64; N]> = shot.minima().map(|(_, state)| state).collect();
    let distance = |a: &[f64; N], b: &[f64; N]| -> f64 {
        (0..N)
            .map(|j| (a[j] - b[j]).abs() / magnitude[j])
            .fold(0.0, f64::max)
    };
    let count = minima.len().max(1);
    let once = (1..count)
        .filter(|k| count.is_multiple_of(*k))
        .find(|&k| (0..count).all(|i| distance(&minima[i], &minima[(i + k) % count]) < SAME_POINT));
    let period = shot.period * once.unwrap_or(count) as f64 / count as f64;
    (period, magnitude)
}

impl<const N: usize, M: Copy> Guess<N, M> {
    /// The same guess, moved onto a converged orbit.
    pub(super) fn moved(&self, found: &Corrected<Shot<N, M>>) -> Self {
        let state = std::array::from_fn(|j| found.z[j]);
        let place = Place {
            state,
            mode: self.place.mode,
        };
        Self {
            place,
            period: found.z[found.z.len() - 1],
            magnitude: self.magnitude,
        }
    }
}
