//! One motion, sampled, with the forces and observables along it.

use crate::field::exact::{ExactSystem, Modes};
use crate::field::{SmoothField, Work};
use crate::flow::{Flow, FlowError, Place, Segment, Want};
use crate::friction::{ContactRule, FrictionLaw};
use crate::model::Model;

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

/// Forces and observables.
type Reading = (Vec<f64>, Vec<f64>);

/// What shows more of a motion than its states.
pub(super) trait Readout<const N: usize, Mode> {
    /// Friction forces and observables at a place.
    fn read(&self, at: &Place<N, Mode>) -> Result<Reading, FlowError>;
}

impl<M: Model<N>, const N: usize> Readout<N, ()> for SmoothField<M, N> {
    fn read(&self, at: &Place<N, ()>) -> Result<Reading, FlowError> {
        let forces = self.forces(&at.state).as_ref().to_vec();
        Ok((forces, self.observables(&at.state).as_ref().to_vec()))
    }
}

/// Reads the sticking forces off the equations.
pub(super) struct ExactReadout<M: Model<N>, const N: usize> {
    values: M::Params<f64>,
    system: ExactSystem<M, N>,
}

impl<M: Model<N>, const N: usize> ExactReadout<M, N> {
    pub(super) fn new(model: M) -> Self {
        Self {
            values: model.values(),
            system: ExactSystem::new(&model, None),
        }
    }
}

impl<M: Model<N>, const N: usize> Readout<N, Modes<M, N>> for ExactReadout<M, N> {
    fn read(&self, at: &Place<N, Modes<M, N>>) -> Result<Reading, FlowError> {
        let contacts = self.system.contact_states(&at.state, &at.mode)?;
        let forces: Vec<f64> = contacts.as_ref().iter().map(|c| c.force).collect();
        let observables = M::observables(&self.values, at.state, &mut Given(&forces));
        let observables = observables.as_ref().to_vec();
        Ok((forces, observables))
    }
}

/// Forces that are known already.
struct Given<'a>(&'a [f64]);

impl ContactRule<f64> for Given<'_> {
    fn force<L: FrictionLaw<f64>>(&mut self, contact: usize, _law: &L, _speed: f64) -> f64 {
        self.0.get(contact).copied().unwrap_or(0.0)
    }
}

/// Follows the motion from `start` for `time`.
pub(super) fn trajectory<F: Flow<N>, const N: usize>(
    flow: &F,
    readout: &impl Readout<N, F::Mode>,
    start: [f64; N],
    time: f64,
) -> Result<Trajectory, FlowError> {
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
    for sample in &passage.path {
        let mode = clock.mode(sample.time).unwrap_or(place.mode);
        let state = sample.state;
        let (forces, observables) = readout.read(&Place { state, mode })?;
        record.times.push(sample.time);
        record.states.push(state.to_vec());
        record.forces.push(forces);
        record.observables.push(observables);
    }
    Ok(record)
}

impl Trajectory {
    /// Widens the extent of each state.
    fn extend<'a, const N: usize>(&mut self, states: impl Iterator<Item = &'a [f64; N]>) {
        for state in states {
            for (j, &value) in state.iter().enumerate() {
                self.min[j] = self.min[j].min(value);
                self.max[j] = self.max[j].max(value);
            }
        }
    }
}

/// Tells the mode of a motion at times that only grow.
struct Clock<'a, Mode> {
    segments: &'a [Segment<Mode>],
    /// When the first of them ends.
    end: f64,
}

impl<'a, Mode: Copy> Clock<'a, Mode> {
    fn new(segments: &'a [Segment<Mode>]) -> Self {
        let end = segments.first().map_or(0.0, |segment| segment.duration);
        Self { segments, end }
    }

    fn mode(&mut self, time: f64) -> Option<Mode> {
        while time > self.end && self.segments.len() > 1 {
            self.segments = &self.segments[1..];
            self.end += self.segments[0].duration;
        }
        self.segments.first().map(|segment| segment.mode)
    }
}
