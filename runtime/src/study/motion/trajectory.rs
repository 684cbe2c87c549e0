//! One motion, sampled, with the forces and observables along it.

use std::ops::ControlFlow;

use super::envelope::Envelope;
use super::extremes::Extremes;
use super::follow::{Point, Row, Stretch, follow};
use crate::field::Work;
use crate::flow::FlowError;
use crate::integrate::IntegrationError;
use crate::study::error::StudyError;
use crate::study::question::Case;
use crate::study::system::System;

/// Numbers up to which rates are kept: curves through more points need none.
const DRAWN: usize = 1 << 17;

/// A motion as it is reported, whatever model it belongs to; one row for each time.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Trajectory {
    /// Times from the beginning.
    pub times: Vec<f64>,
    /// The states at each time.
    pub states: Vec<Vec<f64>>,
    /// The `let` lines at each time.
    pub observables: Vec<Vec<f64>>,
    /// The friction force of each contact at each time.
    pub forces: Vec<Vec<f64>>,
    /// The rates of the states at each time, as the motion comes and as it goes on: others where it has a corner, NaN on the
    /// side of an impact. Nothing if there are so many times that a curve needs no rates.
    pub rates: Vec<[Vec<f64>; 2]>,
    /// Smallest value of each state.
    pub min: Vec<f64>,
    /// Largest value of each state.
    pub max: Vec<f64>,
    /// Each state against time, thinned so that no peak is lost.
    pub envelopes: Vec<Envelope>,
    /// How many samples the motion has.
    pub samples: usize,
    /// Of how many samples one has a row, besides the last and those where a state is least or largest: 1 if all have.
    pub every: usize,
    /// How far it was followed.
    pub time: f64,
    /// What it cost.
    pub work: Work,
}

/// How far a motion is followed, and how much of it is kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// Steps of the integrator, tried ones too, after which it is followed no further.
    pub steps: u64,
    /// Numbers in all rows together; beyond, the rows are thinned.
    pub numbers: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            steps: 1_000_000,
            numbers: 1 << 22,
        }
    }
}

impl System {
    /// The motion from the start of the case for the time `time`, within the default [`Limits`].
    ///
    /// # Errors
    /// The motion cannot be followed, or not within so many steps.
    pub fn motion(&self, case: &Case, time: f64) -> Result<Trajectory, StudyError> {
        let limits = Limits::default();
        let motion = self.motion_within(case, time, limits, &mut |_| ControlFlow::Continue(()))?;
        if motion.time < time {
            let last = motion.states.last().cloned().unwrap_or_default();
            return Err(FlowError::from(IntegrationError::TooManySteps {
                steps: motion.steps(),
                time: motion.time,
                state: last.into(),
            })
            .named(self.info())
            .into());
        }
        Ok(motion)
    }

    /// The motion from the start of the case for the time `time`, or as far as `limits` and `watch` let it go: it is told
    /// now and then of what there is.
    ///
    /// # Errors
    /// The motion cannot be followed.
    pub fn motion_within(
        &self,
        case: &Case,
        time: f64,
        limits: Limits,
        watch: &mut dyn FnMut(&Trajectory) -> ControlFlow<()>,
    ) -> Result<Trajectory, StudyError> {
        let family = self.family(case);
        let start = self.start(case);
        let mut record = Record::new(&start, limits);
        follow(
            (&family, self.beginning(case)),
            (&start, &case.modes),
            time,
            &mut |stretch| {
                record.take(stretch)?;
                let enough = record.motion.steps() >= limits.steps;
                let verdict = watch(&record.motion);
                Ok(if enough {
                    ControlFlow::Break(())
                } else {
                    verdict
                })
            },
        )?;
        Ok(record.motion())
    }
}

impl Trajectory {
    /// Steps of the integrator, tried ones too.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.work.steps + self.work.rejected
    }

    fn push(&mut self, row: Row) {
        self.times.push(row.time);
        self.states.push(row.state);
        self.observables.push(row.observables);
        self.forces.push(row.forces);
    }

    fn row(&self, index: usize) -> Row {
        Row {
            time: self.times[index],
            state: self.states[index].clone(),
            observables: self.observables[index].clone(),
            forces: self.forces[index].clone(),
        }
    }

    /// Numbers in all rows.
    fn numbers(&self) -> usize {
        let all = [&self.states, &self.observables, &self.forces];
        let last = all.into_iter().filter_map(|rows| rows.last());
        self.times.len() * (1 + last.map(Vec::len).sum::<usize>())
    }

    /// Leaves out every second row.
    fn halve(&mut self) {
        fn halve<T>(rows: &mut Vec<T>) {
            let mut index = 0;
            rows.retain(|_| {
                index += 1;
                index % 2 == 1
            });
        }
        halve(&mut self.times);
        halve(&mut self.states);
        halve(&mut self.observables);
        halve(&mut self.forces);
        self.every *= 2;
    }

    /// Takes in rows in the order of time, as far as it does not have them.
    fn merge(&mut self, rows: Vec<Row>) {
        let mut rows = rows.into_iter().peekable();
        let mut merged = Self::default();
        for (index, time) in self.times.iter().enumerate() {
            while let Some(row) = rows.next_if(|row| row.time <= *time) {
                if row.time < *time {
                    merged.push(row);
                }
            }
            merged.push(self.row(index));
        }
        rows.for_each(|row| merged.push(row));
        self.times = merged.times;
        self.states = merged.states;
        self.observables = merged.observables;
        self.forces = merged.forces;
    }

    /// Widens the extent of each state.
    fn extend(&mut self, state: impl Iterator<Item = f64>) {
        for ((value, min), max) in state.zip(&mut self.min).zip(&mut self.max) {
            (*min, *max) = (min.min(value), max.max(value));
        }
    }
}

/// A motion while it is being followed.
struct Record {
    motion: Trajectory,
    limits: Limits,
    /// Rows that the table has besides, whatever is left out of it.
    extremes: Extremes,
}

impl Record {
    fn new(start: &[f64], limits: Limits) -> Self {
        Self {
            motion: Trajectory {
                min: start.to_vec(),
                max: start.to_vec(),
                envelopes: vec![Envelope::default(); start.len()],
                every: 1,
                ..Trajectory::default()
            },
            limits,
            extremes: Extremes::default(),
        }
    }

    fn take(&mut self, stretch: &Stretch<'_>) -> Result<(), FlowError> {
        for extremum in stretch.extrema() {
            self.motion.extend(extremum.values());
            self.extremes.offer(&extremum)?;
        }
        let mut last = None;
        for sample in stretch.samples() {
            self.sample(&sample)?;
            last = Some(sample);
        }
        if let Some(last) = last {
            self.extremes.end(&last)?;
        }
        self.motion.time = stretch.until;
        self.motion.work += stretch.work();
        Ok(())
    }

    fn sample(&mut self, point: &Point<'_>) -> Result<(), FlowError> {
        self.motion.extend(point.values());
        self.extremes.offer(point)?;
        for (envelope, value) in self.motion.envelopes.iter_mut().zip(point.values()) {
            envelope.add([point.time, value]);
        }
        if self.motion.samples.is_multiple_of(self.motion.every) {
            self.motion.push(point.row()?);
            self.rates(point);
            if self.motion.numbers() > self.limits.numbers {
                self.motion.halve();
            }
        }
        self.motion.samples += 1;
        Ok(())
    }

    /// Keeps the rates at the last row, as long as there are few rows.
    fn rates(&mut self, point: &Point<'_>) {
        let (rows, rates) = (self.motion.times.len(), &mut self.motion.rates);
        if 2 * rows * self.motion.min.len() > DRAWN {
            *rates = Vec::new();
        } else if rates.len() + 1 == rows {
            rates.push(point.rates());
        }
    }

    /// What is left of it.
    fn motion(mut self) -> Trajectory {
        if self.motion.every > 1 {
            self.motion.merge(self.extremes.rows());
        }
        self.motion
    }
}
