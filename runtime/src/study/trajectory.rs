//! One motion, sampled, with the forces and observables along it.

use crate::field::Work;
use crate::flow::{Flow, FlowError, SmoothFlow, Want};
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

/// A flow that shows more than its states.
pub(super) trait Readout<const N: usize>: Flow<N> {
    /// Friction forces and observables at a state.
    fn read(&self, state: &[f64; N]) -> (Vec<f64>, Vec<f64>);
}

impl<M: Model<N>, const N: usize> Readout<N> for SmoothFlow<M, N> {
    fn read(&self, state: &[f64; N]) -> (Vec<f64>, Vec<f64>) {
        let field = self.field();
        (
            field.forces(state).as_ref().to_vec(),
            field.observables(state).as_ref().to_vec(),
        )
    }
}

/// Follows the motion from `start` for `time`.
pub(super) fn trajectory<F: Readout<N>, const N: usize>(
    flow: &F,
    start: [f64; N],
    time: f64,
) -> Result<Trajectory, FlowError> {
    let want = Want {
        extrema: true,
        path: true,
        ..Want::default()
    };
    let passage = flow.advance(&flow.place(start)?, time, want)?;
    let mut record = Trajectory {
        min: start.to_vec(),
        max: start.to_vec(),
        work: passage.work,
        ..Trajectory::default()
    };
    let turns = passage.extrema.iter().map(|extremum| extremum.state);
    for state in turns.chain([passage.end.state]) {
        for (j, &value) in state.iter().enumerate() {
            record.min[j] = record.min[j].min(value);
            record.max[j] = record.max[j].max(value);
        }
    }
    for sample in &passage.path {
        let (forces, observables) = flow.read(&sample.state);
        record.times.push(sample.time);
        record.states.push(sample.state.to_vec());
        record.forces.push(forces);
        record.observables.push(observables);
    }
    Ok(record)
}
