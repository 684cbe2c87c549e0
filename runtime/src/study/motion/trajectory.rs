//! One motion, sampled, with the forces and observables along it.

use crate::field::Work;
use crate::flow::{FlowError, Want};
use crate::motion::{Flow, Modes, Place, Sample, Segment};
use crate::study::error::StudyError;
use crate::study::question::Case;
use crate::study::system::System;

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
    /// Smallest value of each state.
    pub min: Vec<f64>,
    /// Largest value of each state.
    pub max: Vec<f64>,
    /// What it cost.
    pub work: Work,
}

impl System {
    /// The motion from the start of the case for the time `time`.
    ///
    /// # Errors
    /// The motion cannot be followed.
    pub fn motion(&self, case: &Case, time: f64) -> Result<Trajectory, StudyError> {
        let flow = self.at(case)?;
        Ok(trajectory(flow.as_ref(), &self.start(case), time)?)
    }
}

/// Follows the motion from `start` for `time`.
fn trajectory(flow: &dyn Flow, start: &[f64], time: f64) -> Result<Trajectory, FlowError> {
    let want = Want {
        extrema: true,
        path: true,
        ..Want::default()
    };
    let place = flow.place(start)?;
    let passage = flow.advance(&place, time, want)?;
    let mut record = Trajectory {
        min: start.to_vec(),
        max: start.to_vec(),
        work: passage.work,
        ..Trajectory::default()
    };
    record.extend(passage.extrema.iter().map(|extremum| &extremum.state));
    record.extend(passage.path.iter().map(|sample| &sample.state));
    let mut clock = Clock::new(&passage.segments);
    for Sample { time, state } in passage.path {
        let modes = clock.modes(time).unwrap_or(&place.modes).clone();
        let here = Place { state, modes };
        let (forces, observables) = flow.read(&here)?;
        record.times.push(time);
        record.states.push(here.state);
        record.forces.push(forces);
        record.observables.push(observables);
    }
    Ok(record)
}

impl Trajectory {
    /// Widens the extent of each state.
    fn extend<'a>(&mut self, states: impl Iterator<Item = &'a Vec<f64>>) {
        for state in states {
            for (j, &value) in state.iter().enumerate() {
                self.min[j] = self.min[j].min(value);
                self.max[j] = self.max[j].max(value);
            }
        }
    }
}

/// Tells the modes of a motion at times that only grow.
struct Clock<'a> {
    segments: &'a [Segment],
    /// When the first of them ends.
    end: f64,
}

impl<'a> Clock<'a> {
    fn new(segments: &'a [Segment]) -> Self {
        let end = segments.first().map_or(0.0, |segment| segment.duration);
        Self { segments, end }
    }

    fn modes(&mut self, time: f64) -> Option<&'a Modes> {
        while time > self.end && self.segments.len() > 1 {
            self.segments = &self.segments[1..];
            self.end += self.segments[0].duration;
        }
        self.segments.first().map(|segment| &segment.modes)
    }
}
