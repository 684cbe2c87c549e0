//! One step of a linear motion at a time.

use super::LinearFlow;
use super::jump::once;
use super::series::Series;
use crate::field::{Point, Work};
use crate::integrate::dense::TERMS;
use crate::integrate::{Carried, Dense, IntegrationError};
use crate::scalar::mapped;

/// Makes steps along a linear field: as long as its dense output is true, or shorter.
#[derive(Debug, Clone)]
pub(crate) struct LinearStepper<'f, V, const N: usize> {
    flow: &'f LinearFlow<N>,
    /// Steps after which to give up.
    budget: u64,
    time: f64,
    from: V,
    /// The state where the step begins, and the wave of the drive.
    start: Point<N>,
    end: [f64; N],
    length: f64,
    /// The way of the last attempt.
    dense: Dense<N>,
    /// Its series, once it is needed.
    series: Option<Series<N>>,
    pub(crate) work: Work,
}

impl<'f, V: Carried<N>, const N: usize> LinearStepper<'f, V, N> {
    /// Begins at `from`.
    pub(crate) fn new(flow: &'f LinearFlow<N>, budget: u64, from: V, time: f64) -> Self {
        let state = *from.state();
        Self {
            flow,
            budget,
            time,
            from,
            start: (state, flow.field.wave(&state)),
            end: state,
            length: 0.0,
            dense: Dense::of_terms(state, 0.0, [[0.0; N]; TERMS]),
            series: None,
            work: Work::default(),
        }
    }

    /// Whether a motion can begin here.
    ///
    /// # Errors
    /// `NotFinite` if the state is not.
    pub(crate) fn check_start(&self) -> Result<(), IntegrationError> {
        if self.from.is_finite() {
            Ok(())
        } else {
            Err(self.not_finite())
        }
    }

    pub(crate) fn from(&self) -> &V {
        &self.from
    }

    /// The state at the end of the step.
    pub(crate) fn end(&self) -> &[f64; N] {
        &self.end
    }

    pub(crate) fn time(&self) -> f64 {
        self.time
    }

    pub(crate) fn length(&self) -> f64 {
        self.length
    }

    /// Makes a step at most `limit` long, from where the last was committed.
    ///
    /// # Errors
    /// `NotFinite` or `TooManySteps`.
    pub(crate) fn attempt(&mut self, limit: f64) -> Result<(), IntegrationError> {
        if self.work.steps >= self.budget {
            return Err(IntegrationError::TooManySteps {
                steps: self.work.steps,
                time: self.time,
                state: self.start.0.to_vec().into(),
            });
        }
        self.work.evaluations += 1;
        let length = limit.min(self.flow.longest);
        self.series = None;
        self.dense = match self.flow.whole(length) {
            Some(jump) => jump.path(&self.start),
            None => {
                let series = self.expand(length);
                self.series = Some(series);
                Dense::of_terms(self.start.0, length, series.path())
            }
        };
        self.arrive(length, self.dense.end())
    }

    /// Makes the same step with another length, not longer.
    ///
    /// # Errors
    /// `NotFinite` if the end is not.
    pub(crate) fn shorten(&mut self, length: f64) -> Result<(), IntegrationError> {
        let end = self.step_map(length);
        self.arrive(length, end)
    }

    /// The state to which a step of this length would lead, no longer than the last attempt.
    pub(crate) fn step_map(&mut self, length: f64) -> [f64; N] {
        let whole = self.dense.length();
        if whole == 0.0 {
            return self.start.0;
        }
        if self.series.is_none() {
            self.series = Some(self.expand(whole));
        }
        let series = self.series.as_ref();
        series.map_or(self.end, |series| series.state(length / whole))
    }

    /// f at any state.
    pub(crate) fn slope_at(&self, state: &[f64; N]) -> [f64; N] {
        self.flow.field.f(state)
    }

    /// The polynomial of degree 7 through the step.
    pub(crate) fn dense(&self) -> Dense<N> {
        if self.length == self.dense.length() {
            return self.dense;
        }
        let path = self.expand(self.length).path();
        Dense::of_terms(self.start.0, self.length, path)
    }

    /// The end of the step, with its derivatives where they are carried.
    ///
    /// # Errors
    /// `NotFinite` if they are not.
    fn arrived(&self) -> Result<V, IntegrationError> {
        let (flow, length) = (self.flow, self.length);
        let end = self.from.led_to(self.end, || match flow.whole(length) {
            Some(jump) => jump.propagator(&flow.field, &self.start),
            None => once(&flow.field, &self.start, length, flow.degree),
        });
        if end.is_finite() {
            Ok(end)
        } else {
            Err(self.not_finite())
        }
    }

    /// How far the dense output of the last attempt is off, relative to the magnitude of the motion.
    pub(crate) fn error(&self) -> f64 {
        self.flow.error(self.dense.length())
    }

    /// The magnitude of the terms of each state along the step.
    pub(crate) fn terms(&self) -> [f64; N] {
        let mut terms = mapped(&self.start.0, f64::abs);
        terms.add(self.length, &self.flow.field.terms(&self.start));
        terms
    }

    /// Takes the end of the step without `drift`, a rounding error of it, as the beginning of the next.
    ///
    /// # Errors
    /// `NotFinite` if the derivatives are not.
    pub(crate) fn commit_without(&mut self, drift: &[f64; N]) -> Result<(), IntegrationError> {
        self.from = self.arrived()?;
        self.from.state_mut().add(-1.0, drift);
        self.work.steps += 1;
        self.time += self.length;
        self.end = *self.from.state();
        self.start = (self.end, self.flow.field.wave(&self.end));
        Ok(())
    }

    fn expand(&self, length: f64) -> Series<N> {
        Series::new(&self.flow.field, &self.start, length, self.flow.degree)
    }

    fn arrive(&mut self, length: f64, end: [f64; N]) -> Result<(), IntegrationError> {
        self.length = length;
        self.end = end;
        if end.is_finite() {
            Ok(())
        } else {
            Err(self.not_finite())
        }
    }

    fn not_finite(&self) -> IntegrationError {
        IntegrationError::NotFinite {
            time: self.time,
            state: self.start.0.to_vec().into(),
        }
    }
}
