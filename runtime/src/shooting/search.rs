//! From a start to a converged, minimal, well-anchored periodic orbit.

use nalgebra::DVector;

use super::guess::{Guess, Settled, settle};
use super::orbit::{Orbit, Solution};
use super::phase::Phase;
use super::problem::{OrbitProblem, Shot};
use crate::continuation::{Corrected, Failure, correct};
use crate::flow::{Family, Flow, FlowError, Place};
use crate::integrate::Tolerance;

type Mode<F, const N: usize> = <<F as Family<N>>::Flow as Flow<N>>::Mode;
type Found<F, const N: usize> = Corrected<Shot<N, Mode<F, N>>>;

/// An orbit whose extent is below this share of its states is an equilibrium.
const EXTENT: f64 = 1e-6;
/// Two points of the section closer than this are one.
const SAME_POINT: f64 = 1e-5;

/// What to look for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Search<const N: usize> {
    /// Where to begin.
    pub start: [f64; N],
    /// A guess of the period; then Newton begins at once.
    pub period: Option<f64>,
    /// Relative accuracy of period and extrema.
    pub accuracy: f64,
    /// Number of shooting segments.
    pub segments: usize,
}

/// Why no orbit was found.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum OrbitError {
    /// The motion came to rest.
    #[error(
        "the motion settles on an equilibrium at {state:?}: there is no periodic orbit to be found from this start"
    )]
    Equilibrium {
        /// The equilibrium.
        state: Vec<f64>,
    },
    /// Neither rest nor a periodic motion within bounds.
    #[error(
        "the motion has not settled on a periodic orbit after the time {time:.6}; give `--start` and `--period`, or another start"
    )]
    NotSettled {
        /// Time followed.
        time: f64,
    },
    /// Newton failed.
    #[error("shooting did not converge: {0}")]
    Newton(Failure<FlowError>),
    /// The motion cannot be followed.
    #[error(transparent)]
    Flow(#[from] FlowError),
}

/// Finds the periodic orbit of `family` at r that is reached from `search.start`.
///
/// # Errors
/// See [`OrbitError`].
pub fn closest<F: Family<N> + Clone, const N: usize>(
    family: &F,
    r: f64,
    search: &Search<N>,
) -> Result<Orbit<N, Mode<F, N>>, OrbitError> {
    let loose = family
        .with_tolerance(Tolerance::for_accuracy(1e-7))
        .with_magnitude(magnitude_of(&search.start))
        .at(r)?;
    let start = loose.place(search.start)?;
    if let Some(period) = search.period {
        let magnitude = magnitude_of(&search.start);
        return converge(
            family,
            r,
            &Guess {
                place: start,
                period,
                magnitude,
            },
            search,
        );
    }
    match settle(&loose, start, |guess| {
        converge(family, r, guess, search).ok()
    })? {
        Settled::Orbit(orbit) => Ok(orbit),
        Settled::Equilibrium(state) => Err(OrbitError::Equilibrium {
            state: state.to_vec(),
        }),
        Settled::Neither(time) => Err(OrbitError::NotSettled { time }),
    }
}

/// Magnitudes as far as a start shows them: that of its largest component where one is zero or next to it.
fn magnitude_of<const N: usize>(start: &[f64; N]) -> [f64; N] {
    let largest = start.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let other = if largest > 0.0 { largest } else { 1.0 };
    start.map(|x| {
        if x.abs() > 1e-3 * other {
            x.abs()
        } else {
            other
        }
    })
}

/// Newton from a guess: on the section if the guess lies there, then to the minimal period, then with
/// a tighter tolerance, which gives the error estimate.
///
/// # Errors
/// See [`OrbitError`].
pub fn converge<F: Family<N> + Clone, const N: usize>(
    family: &F,
    r: f64,
    guess: &Guess<N, Mode<F, N>>,
    search: &Search<N>,
) -> Result<Orbit<N, Mode<F, N>>, OrbitError> {
    let Search {
        accuracy, segments, ..
    } = *search;
    let fine = Tolerance::for_accuracy(accuracy);
    let rough = Tolerance::for_accuracy(accuracy.max(1e-7));
    let effort = |accuracy: f64, tolerance: Tolerance, factors: bool| Effort {
        accuracy,
        tolerance,
        factors,
    };
    let rough = newton(
        family,
        r,
        guess,
        segments,
        effort(accuracy.max(1e-7), rough, false),
    )?;
    let guess = anchored(family, r, &rough.0)?;
    let loose = newton(family, r, &guess, segments, effort(accuracy, fine, false))?;
    let guess = guess.moved(&loose.0);
    let (tight, problem) = newton(
        family,
        r,
        &guess,
        segments,
        effort(accuracy, fine.times(0.1), N > 2),
    )?;
    let mut work = problem.work;
    work += loose.1.work;
    work += rough.1.work;
    let accuracy = difference(&loose.0, &tight);
    let shot = &tight.linearisation.extra;
    let solution = Solution {
        shot,
        z: &tight.z,
        r,
        residual: tight.residual,
    };
    Ok(Orbit::read(family, solution, accuracy, work))
}

type Converged<F, const N: usize> = (Found<F, N>, OrbitProblem<F, N>);

/// What one Newton iteration is to reach, and to report.
#[derive(Debug, Clone, Copy)]
struct Effort {
    accuracy: f64,
    tolerance: Tolerance,
    factors: bool,
}

/// Shooting with the flow at the tolerance for `effort.tolerance`; refuses an equilibrium.
fn newton<F: Family<N> + Clone, const N: usize>(
    family: &F,
    r: f64,
    guess: &Guess<N, Mode<F, N>>,
    segments: usize,
    effort: Effort,
) -> Result<Converged<F, N>, OrbitError> {
    let family = family
        .with_tolerance(effort.tolerance)
        .with_magnitude(guess.magnitude);
    if at_rest(&family.at(r)?, guess)? {
        return Err(OrbitError::Equilibrium {
            state: guess.place.state.to_vec(),
        });
    }
    let (mut problem, z) = problem(family, r, guess, segments)?;
    problem.want.factors = effort.factors;
    let mut normal = DVector::zeros(z.len() + 1);
    normal[z.len()] = 1.0;
    let found =
        correct(&mut problem, z, r, &normal, 1.0, effort.accuracy).map_err(OrbitError::Newton)?;
    let shot = &found.linearisation.extra;
    let (low, high) = shot.extent();
    let flat = (0..N).all(|j| {
        high[j] - low[j] <= EXTENT * low[j].abs().max(high[j].abs()).max(guess.magnitude[j])
    });
    if flat {
        return Err(OrbitError::Equilibrium {
            state: shot.start.state.to_vec(),
        });
    }
    Ok((found, problem))
}

/// Whether a guess hardly moves in its period: there Newton's matrix is singular for any period.
fn at_rest<F: Flow<N>, const N: usize>(
    flow: &F,
    guess: &Guess<N, F::Mode>,
) -> Result<bool, FlowError> {
    let velocity = flow.velocity(&guess.place)?.f;
    Ok((0..N).all(|j| velocity[j].abs() * guess.period <= EXTENT * guess.magnitude[j]))
}

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
    let phase = phase(&guess.place.state, &velocity, guess);
    let states: Vec<[f64; N]> = places.iter().map(|place| place.state).collect();
    let z = OrbitProblem::<F, N>::unknowns(&states, guess.period);
    Ok((
        OrbitProblem::new(family, phase, &places, guess.period, guess.magnitude),
        z,
    ))
}

/// The default section where the guess lies on it and crosses it, else orthogonality to the field.
fn phase<const N: usize, M>(
    state: &[f64; N],
    velocity: &crate::flow::Velocity<N>,
    guess: &Guess<N, M>,
) -> Phase<N> {
    let speed = velocity.f[0].abs() * guess.period / (std::f64::consts::TAU * guess.magnitude[0]);
    let bend: f64 = (0..N)
        .map(|j| velocity.jacobian[0][j] * velocity.f[j])
        .sum();
    let turn = bend.abs() * (guess.period / std::f64::consts::TAU).powi(2) / guess.magnitude[0];
    if speed < 1e-2 * turn && turn > 1e-3 {
        Phase::Section(0)
    } else {
        Phase::Orthogonal {
            at: *state,
            velocity: velocity.f,
        }
    }
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
    let (low, high) = shot.extent();
    let magnitude: [f64; N] = std::array::from_fn(|j| {
        let half = 0.5 * (high[j] - low[j]);
        if half > 0.0 { half } else { 1.0 }
    });
    let minima: Vec<(f64, [f64; N])> = shot.minima().collect();
    let flow = family.at(r)?;
    let Some(&(_, first)) = minima.first() else {
        return Ok(Guess {
            place: shot.start,
            period: shot.period,
            magnitude,
        });
    };
    let place = if first == shot.start.state {
        shot.start
    } else {
        flow.place(first)?
    };
    let distance = |a: &[f64; N], b: &[f64; N]| -> f64 {
        (0..N)
            .map(|j| (a[j] - b[j]).abs() / magnitude[j])
            .fold(0.0, f64::max)
    };
    // The motion may have gone around several times: find the first return that repeats throughout.
    let count = minima.len();
    let once = (1..count).filter(|k| count.is_multiple_of(*k)).find(|&k| {
        (0..count).all(|i| distance(&minima[i].1, &minima[(i + k) % count].1) < SAME_POINT)
    });
    let period = shot.period * once.unwrap_or(count) as f64 / count as f64;
    Ok(Guess {
        place,
        period,
        magnitude,
    })
}

impl<const N: usize, M: Copy> Guess<N, M> {
    /// The same guess, moved onto a converged orbit.
    fn moved(&self, found: &Corrected<Shot<N, M>>) -> Self {
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

/// Largest relative difference of period and extrema between two computations of one orbit.
fn difference<const N: usize, M>(a: &Corrected<Shot<N, M>>, b: &Corrected<Shot<N, M>>) -> f64 {
    let (first, second) = (&a.linearisation.extra, &b.linearisation.extra);
    let period = (a.z[a.z.len() - 1] / b.z[b.z.len() - 1] - 1.0).abs();
    let ((low_a, high_a), (low_b, high_b)) = (first.extent(), second.extent());
    (0..N).fold(period.max(1e-15), |largest, j| {
        let size = high_b[j].abs().max(low_b[j].abs()).max(f64::MIN_POSITIVE);
        largest
            .max((high_a[j] - high_b[j]).abs() / size)
            .max((low_a[j] - low_b[j]).abs() / size)
    })
}
