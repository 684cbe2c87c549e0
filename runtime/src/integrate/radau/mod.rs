//! Radau IIA: full Newton on exact stage Jacobians, kinematic rows eliminated, and the exact
//! derivative of the discrete step from one more solve with the last factorisation.

mod control;
mod derivative;
mod estimate;
mod inside;
mod kink;
mod layout;
mod stages;

use super::collocation::Collocation;
use super::tableau::Tableau;
use super::{IntegrationError, Tolerance};
use crate::field::{Field, Linear, Work};
use crate::model::Values;
use control::{first_step, fitting};
use kink::Kink;
use stages::Trial;

const NEWTON_ITERATIONS: usize = 9;
const SAFETY: f64 = 0.85;
const SHRINK: f64 = 0.15;
const GROW: f64 = 6.0;

/// An implicit integrator under way along one motion.
#[derive(Debug)]
pub struct Radau<'f, F, const N: usize, const S: usize> {
    field: &'f F,
    tableau: &'static Tableau<S>,
    tolerance: Tolerance,
    time: f64,
    state: [f64; N],
    start: Linear<N>,
    departure: Linear<N>,
    next: f64,
    before: Option<Before<N, S>>,
    rejected: bool,
    last: Trial<N, S>,
    budget: u64,
    fallen: Option<usize>,
    /// Counted work.
    pub work: Work,
}

/// What the step before leaves for the next one.
#[derive(Debug, Clone, Copy)]
struct Before<const N: usize, const S: usize> {
    step: f64,
    error: f64,
    collocation: Collocation<N, S>,
}

/// An accepted step.
#[derive(Debug, Clone, Copy)]
pub struct Accepted<const N: usize, const S: usize> {
    /// Time at its beginning.
    pub time: f64,
    /// Its length.
    pub step: f64,
    /// State at its beginning.
    pub start: [f64; N],
    /// State at its end.
    pub end: [f64; N],
    /// Increment in between.
    pub collocation: Collocation<N, S>,
}

impl<'f, F: Field<N>, const N: usize, const S: usize> Radau<'f, F, N, S> {
    /// Sets out from `state`; `step` is a first step to try, or 0 to have one chosen.
    ///
    /// # Errors
    /// The field is not finite at `state`.
    pub fn new(
        field: &'f F,
        tableau: &'static Tableau<S>,
        tolerance: Tolerance,
        state: [f64; N],
        step: f64,
        budget: u64,
    ) -> Result<Self, IntegrationError> {
        let start = field.linearise(&state);
        if !start.f.iter().all(|component| component.is_finite()) {
            return Err(IntegrationError::NotFinite {
                time: 0.0,
                state: state.to_vec().into(),
            });
        }
        let next = if step > 0.0 {
            step
        } else {
            first_step(&start, &field.scale(&state, &tolerance), S)
        };
        Ok(Self {
            field,
            tableau,
            tolerance,
            time: 0.0,
            state,
            start,
            departure: start,
            next,
            before: None,
            rejected: false,
            last: Trial::blank(state, start),
            budget,
            fallen: None,
            work: Work {
                linearisations: 1,
                ..Work::default()
            },
        })
    }

    /// Time from the beginning.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.time
    }

    /// State reached.
    #[must_use]
    pub fn state(&self) -> [f64; N] {
        self.state
    }

    /// The number of the guard of the field that fell at the end of the last step, if one did.
    #[must_use]
    pub fn fallen(&self) -> Option<usize> {
        self.fallen
    }

    /// Makes one step that ends at `end` at the latest, and on a kink of the field if it meets one.
    ///
    /// # Errors
    /// See [`IntegrationError`].
    pub fn step(&mut self, end: f64) -> Result<Accepted<N, S>, IntegrationError> {
        loop {
            let rest = end - self.time;
            let mut step = fitting(self.next, rest);
            if self.work.steps + self.work.rejected >= self.budget {
                return Err(
                    self.stuck(|steps, time, state| IntegrationError::TooManySteps {
                        steps,
                        time,
                        state,
                    }),
                );
            }
            if step <= 4.0 * f64::EPSILON * self.time.abs().max(f64::MIN_POSITIVE) {
                return Err(IntegrationError::StepTooSmall {
                    time: self.time,
                    step,
                    state: self.state.to_vec().into(),
                });
            }
            let guess = self.predict(step);
            let Some(mut trial) = self.solve(step, guess) else {
                self.reject(0.3 * step);
                continue;
            };
            let error = self.error(&trial);
            if error > 1.0 || error.is_nan() {
                self.reject(
                    step * (SAFETY * error.powf(-1.0 / (S as f64 + 1.0))).clamp(SHRINK, 0.9),
                );
                continue;
            }
            if self.field.leaps(&trial.start, &trial.end()) {
                self.reject(0.3 * step);
                continue;
            }
            let mut collocation = Collocation::new(self.tableau, &trial.increments);
            match self.stop_at_kink(&trial, &collocation) {
                Kink::None => {}
                Kink::At(shorter) => {
                    trial = shorter;
                    step = trial.step;
                    collocation = Collocation::new(self.tableau, &trial.increments);
                }
                Kink::Missed(theta) => {
                    self.reject(step * (0.7 * theta).clamp(0.01, 0.7));
                    continue;
                }
            }
            return Ok(self.accept(trial, collocation, error, step, end));
        }
    }

    fn stuck(&self, error: impl FnOnce(u64, f64, Values) -> IntegrationError) -> IntegrationError {
        error(self.work.steps, self.time, self.state.to_vec().into())
    }

    fn reject(&mut self, shorter: f64) {
        self.work.rejected += 1;
        self.rejected = true;
        self.next = if shorter.is_finite() {
            shorter
        } else {
            0.1 * self.next
        };
    }

    fn accept(
        &mut self,
        trial: Trial<N, S>,
        collocation: Collocation<N, S>,
        error: f64,
        step: f64,
        end: f64,
    ) -> Accepted<N, S> {
        let accepted = Accepted {
            time: self.time,
            step,
            start: self.state,
            end: trial.end(),
            collocation,
        };
        let grown = self.grow(error, step, trial.iterations);
        self.next = if step < self.next && trial.step == step {
            self.next.max(grown.min(GROW * step))
        } else {
            grown
        };
        self.before = Some(Before {
            step,
            error: error.max(1e-2),
            collocation,
        });
        self.rejected = false;
        self.work.steps += 1;
        self.time = if self.time + step >= end - 4.0 * f64::EPSILON * end.abs() {
            end
        } else {
            self.time + step
        };
        self.state = accepted.end;
        self.departure = self.start;
        self.start = trial.arrival();
        self.last = trial;
        accepted
    }
}

fn add<const N: usize>(a: &[f64; N], b: &[f64; N]) -> [f64; N] {
    crate::scalar::filled(|j| a[j] + b[j])
}
