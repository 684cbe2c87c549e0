//! The phase of a drive: a state that only advances, and of which 2π more is the same.

use std::f64::consts::TAU;

use super::{Extremum, FlowError};
use crate::field::Frictionless;
use crate::model::Model;

/// Appends each instant of a step at which the phase begins anew, as a minimum of it.
///
/// The phase advances uniformly, so that the instants are known; `probe` is the step map at a fraction of the step.
pub(crate) fn strobes<const N: usize>(
    phase: Option<usize>,
    (from, to): (&[f64; N], &[f64; N]),
    (time, length): (f64, f64),
    found: &mut Vec<Extremum<N>>,
    mut probe: impl FnMut(f64) -> Option<[f64; N]>,
) {
    let Some(index) = phase else { return };
    let (from, to) = (from[index], to[index]);
    let mut turns = (from / TAU).floor() + 1.0;
    while turns * TAU <= to {
        let theta = (turns * TAU - from) / (to - from);
        if let Some(mut state) = probe(theta) {
            state[index] = 0.0;
            found.push(Extremum {
                index,
                maximum: false,
                time: time + theta * length,
                state,
            });
        }
        turns += 1.0;
    }
}

/// Turns of a drive that can be noted at once.
const NOTED: f64 = 1e5;
/// Turns for which a motion is followed at once by those who have more to follow.
const FOLLOWED: f64 = 1e4;

/// The longest time for which a motion should be followed at once, its phase advancing at this rate.
pub(crate) fn longest(rate: f64) -> f64 {
    FOLLOWED * TAU / rate.abs()
}

/// That the turns of a drive in a time are few enough to be noted.
///
/// # Errors
/// At this rate they are not.
pub(crate) fn countable(rate: f64, time: f64) -> Result<(), FlowError> {
    let turns = rate.abs() * time / TAU;
    if turns > NOTED {
        return Err(FlowError::TooManyTurns { turns, time });
    }
    Ok(())
}

/// Whether the drive of a model does not advance.
///
/// # Errors
/// It stands still or turns backwards.
pub(crate) fn standing<M: Model<N>, const N: usize>(
    params: &M::Params<f64>,
) -> Result<(), FlowError> {
    let Some(index) = M::INFO.drive else {
        return Ok(());
    };
    let start = crate::scalar::filled(|i| M::INFO.states[i].start);
    let rate = M::rhs(params, start, &mut Frictionless)[index];
    if rate > 0.0 && rate.is_finite() {
        return Ok(());
    }
    let name = M::INFO.states[index].name;
    Err(FlowError::Standing { name, rate })
}
