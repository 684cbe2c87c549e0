//! One orbit at one tolerance, shot from a guess nearby.

use std::time::Instant;

use crate::continuation::{Branch, Settings, Stop, correct_at};
use crate::field::Work;
use crate::flow::{FlowError, Want};
use crate::integrate::Tolerance;
use crate::motion::{Family, Place};
use crate::shooting::{Guess, OrbitError, Pin, problem, through};

use super::lost::Lost;
use super::record::Cost;

/// Repetitions of which the fastest counts.
const REPEATS: usize = 3;
/// Share of the unit of a state that is rounding error.
const NOTHING: f64 = 1e-14;
/// Relative extent below which an orbit is an equilibrium.
const EXTENT: f64 = 1e-6;

/// How hard an orbit is tried for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Effort {
    pub(super) tolerance: Tolerance,
    /// Newton's last correction.
    pub(super) accuracy: f64,
}

impl Effort {
    /// At which errors of smoothing are measured.
    pub(super) const TIGHT: Self = Self::at(1e-9, 1e-10);

    pub(super) const fn at(tolerance: f64, accuracy: f64) -> Self {
        Self {
            tolerance: Tolerance::both(tolerance),
            accuracy,
        }
    }
}

/// A converged orbit, as far as a trade is concerned.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shooting {
    pub(super) state: Vec<f64>,
    pub(super) period: f64,
    pub(super) min: Vec<f64>,
    pub(super) max: Vec<f64>,
    magnitude: Vec<f64>,
    pins: Vec<Pin>,
    shift: Option<Vec<f64>>,
    /// Crossings of the section.
    pub(super) count: usize,
    /// Newton's last correction.
    pub(super) resolution: f64,
    pub(super) work: Work,
}

impl Shooting {
    pub(super) fn max_abs(&self) -> Vec<f64> {
        let pairs = self.max.iter().zip(&self.min);
        pairs.map(|(max, min)| max.abs().max(min.abs())).collect()
    }

    /// As a guess for a smooth copy, which has no modes.
    pub(super) fn guess(&self) -> Guess {
        Guess {
            place: Place {
                state: self.state.clone(),
                modes: Vec::new(),
            },
            period: self.period,
            magnitude: self.magnitude.clone(),
            pins: self.pins.clone(),
            shift: self.shift.clone(),
            division: None,
        }
    }

    /// Relative, signed errors of frequency and largest magnitudes against `truth`; of what is nothing there, in the units in
    /// which it is followed.
    pub(super) fn errors(&self, truth: &Self) -> (f64, Vec<f64>) {
        let pairs = self.max_abs().into_iter().zip(truth.max_abs());
        let error = |((a, b), unit): ((f64, f64), &f64)| match b > NOTHING * unit {
            true => a / b - 1.0,
            false => (a - b) / unit,
        };
        (
            truth.period / self.period - 1.0,
            pairs.zip(&truth.magnitude).map(error).collect(),
        )
    }

    /// The largest of them.
    pub(super) fn error(&self, truth: &Self) -> f64 {
        let (frequency, max_abs) = self.errors(truth);
        largest(frequency, &max_abs)
    }
}

/// The largest magnitude of these errors.
pub(super) fn largest<'a>(frequency: f64, others: impl IntoIterator<Item = &'a f64>) -> f64 {
    let others = others.into_iter();
    others.fold(frequency.abs(), |most, error| most.max(error.abs()))
}

/// Newton from a guess.
pub(super) fn shoot(
    family: &Family,
    r: f64,
    guess: &Guess,
    effort: Effort,
) -> Result<Shooting, OrbitError> {
    let family = family.with_tolerance(effort.tolerance);
    let (mut problem, z) = problem(family, r, guess, 1)?;
    let found = correct_at(&mut problem, z, r, effort.accuracy).map_err(OrbitError::Newton)?;
    let shot = &found.linearisation.extra;
    let (min, max) = shot.extent();
    let size = |j: usize| guess.magnitude[j].max(max[j].abs());
    if (0..max.len()).all(|j| max[j] - min[j] <= EXTENT * size(j)) {
        return Err(OrbitError::Equilibrium {
            state: problem.family.at(r)?.values(&shot.start.state),
        });
    }
    Ok(Shooting {
        magnitude: shot.magnitude(&vec![1.0; max.len()]),
        pins: shot.pins.clone(),
        shift: shot.shift.clone(),
        state: found.z.rows(0, max.len()).iter().copied().collect(),
        period: found.z[max.len()],
        min,
        max,
        count: shot.minima().count().max(1),
        resolution: found.corrections.last().copied().unwrap_or(f64::NAN),
        work: problem.work,
    })
}

/// Follows an orbit from r = `from` to r = `to`; a guess there, or why the branch ended before.
pub(super) fn follow(
    family: &Family,
    (from, to): (f64, f64),
    start: &Guess,
    effort: Effort,
) -> Result<(Guess, Work), Lost> {
    let family = family.with_tolerance(effort.tolerance);
    let (mut problem, z) = problem(family, from, start, 1)?;
    problem.float(&start.place, from)?;
    let settings = Settings::new(from, to, effort.accuracy.max(1e-8));
    let (mut branch, first) = Branch::start(problem, z, settings)?;
    let last = branch.by_ref().last().unwrap_or(first);
    match branch.stop() {
        Some(Stop::ReachedEnd) => {
            let lowest = last.extra.minima().min_by(|a, b| a.1[0].total_cmp(&b.1[0]));
            let state = lowest.map_or(last.extra.start.state.clone(), |(_, state)| state);
            let guess = Guess {
                place: Place {
                    state: state.clone(),
                    modes: last.extra.start.modes.clone(),
                },
                period: last.extra.period,
                magnitude: last.extra.magnitude(&vec![1.0; state.len()]),
                pins: through(&last.extra.pins, &state),
                shift: last.extra.shift.clone(),
                division: None,
            };
            Ok((guess, branch.problem.work))
        }
        stop => Err(Lost::Ends {
            size: last.r.exp(),
            stop: stop.cloned(),
        }),
    }
}

/// What one period with derivatives and extrema costs at the family's tolerance.
pub(super) fn cost(family: &Family, shooting: &Shooting) -> Result<Cost, FlowError> {
    let mut cost = Cost {
        seconds: f64::INFINITY,
        ..Cost::default()
    };
    for _ in 0..REPEATS {
        let clock = Instant::now();
        let flow = family.at(0.0)?;
        let passage = flow.advance(&flow.place(&shooting.state)?, shooting.period, Want::SHOT)?;
        cost.seconds = cost.seconds.min(clock.elapsed().as_secs_f64());
        cost.work = passage.work;
    }
    Ok(cost)
}
