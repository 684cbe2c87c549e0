//! Motions of any system behind one interface: the joint between what a model is and what is asked of it.
//!
//! Below, everything is generic over the model and its number of states N, and no step touches the heap. Here both are
//! erased: a call of [`Flow::advance`] integrates for 10 to 400 µs, so that one virtual call and one conversion cost
//! nothing that can be measured, and all that stands above is compiled once.

mod contacts;
mod enclosure;
pub(crate) mod exact;
mod extent;
mod family;
mod modes;
mod passage;
mod rounding;
mod smooth;
mod tape;

pub use contacts::{Contact, Contacts, Row};
pub use enclosure::{Enclosed, Enclosure};
pub use extent::half_extents;
pub(crate) use extent::{NOISE, STILL, apart, bounds, is_still};
pub use family::{Family, Flows};
pub use modes::{Modes, spelt, sticking, word};
pub use passage::{
    Calm, Derivatives, Event, Extremum, Factor, Node, Passage, Place, Sample, Segment, Velocity,
};
pub(crate) use passage::{fixed, most_stuck};
pub use tape::{Note, Tape};

use std::f64::consts::TAU;

use crate::field::exact::Mode;
use crate::flow::{FlowError, Want};
use crate::model::Values;

/// Friction forces, and the `let` lines, at one place.
pub type Reading = (Vec<f64>, Vec<f64>);

/// The motion of a system with any number of states: smooth and exact systems are both just flows.
pub trait Flow: Send + Sync {
    /// The number of states.
    fn order(&self) -> usize;

    /// The state that is the phase of a drive, if there is one: 2π more of it is the same.
    ///
    /// It has no extrema; in their place a passage reports each time at which it begins anew, there as 0.
    fn phase(&self) -> Option<usize>;

    /// A state by the names of its model, for a message.
    fn values(&self, state: &[f64]) -> Values;

    /// The place of a state: decides the modes from which the motion will continue.
    ///
    /// # Errors
    /// No mode is consistent with the state.
    fn place(&self, state: &[f64]) -> Result<Place, FlowError>;

    /// The place of a state that was reached in these modes: they go on, unless it cannot be one of theirs, or there are
    /// none; then it decides alone.
    ///
    /// # Errors
    /// No mode is consistent with the state.
    fn place_in(&self, state: &[f64], _modes: &[Mode]) -> Result<Place, FlowError> {
        self.place(state)
    }

    /// Follows the motion from `from` for the time `time` ≥ 0.
    ///
    /// # Errors
    /// Any [`FlowError`]; a result is never NaN.
    fn advance(&self, from: &Place, time: f64, want: Want) -> Result<Passage, FlowError>;

    /// f and its derivatives at a place (one-sided where the motion will continue).
    ///
    /// # Errors
    /// The field is not finite there, or no mode is consistent.
    fn velocity(&self, at: &Place) -> Result<Velocity, FlowError>;

    /// The motion from `from` for the time `time`, in the mode in which it begins whatever its guards say.
    ///
    /// # Errors
    /// The motion cannot be followed.
    fn glide(&self, from: &Place, time: f64) -> Result<(Place, Derivatives), FlowError>;

    /// What ends the mode of a contact where it falls through zero, and its rate: the relative speed the way it slides, or
    /// what the force of one that sticks lacks to its limit; `None` if there is no such contact.
    ///
    /// # Errors
    /// The forces are not determined there.
    fn touch(&self, _at: &Place, _contact: usize) -> Result<Option<[f64; 2]>, FlowError> {
        Ok(None)
    }

    /// What keeps a press closed while it is positive, or lets it go while it is negative, the way its mode needs it, and its
    /// rate; `None` if there is no such press, or it does not give way.
    ///
    /// # Errors
    /// The forces are not determined there.
    fn hold(&self, _at: &Place, _contact: usize) -> Result<Option<[f64; 2]>, FlowError> {
        Ok(None)
    }

    /// By what share of its limit at rest the force of a contact drops where it lets go; 0 if there is no such contact.
    fn loosening(&self, _state: &[f64], _contact: usize) -> f64 {
        0.0
    }

    /// What a unit speed of approach adds to the state at an impact that is as slow as may be; `None` if there is no such contact, or it gives way.
    ///
    /// # Errors
    /// The impulses are not determined there.
    fn kick(&self, _at: &Place, _contact: usize) -> Result<Option<Vec<f64>>, FlowError> {
        Ok(None)
    }

    /// For each sliding contact its number and its relative speed the way it slides, for each that sticks what it could bear
    /// besides, for each press its gap or depth, or the reaction to what rests on it: not positive beyond the mode.
    fn margins(&self, _at: &Place) -> Vec<(usize, f64)> {
        Vec::new()
    }

    /// The relative speed of every set-valued contact at a state, and the gap of every press; none for a smooth system.
    fn speeds(&self, _state: &[f64]) -> Vec<f64> {
        Vec::new()
    }

    /// The number of surfaces on which laws with internal state have a corner.
    fn corners(&self) -> usize {
        0
    }

    /// The magnitude at which a state that a law carries stops; infinite for any other.
    fn stop(&self, _state: usize) -> f64 {
        f64::INFINITY
    }

    /// The same modes, those contacts loose, and only those, whose presses are open; what no longer is slides the way of
    /// its speed.
    fn loosened(&self, modes: Modes, _speeds: &[f64]) -> Modes {
        modes
    }

    /// The same modes, those contacts pinned, and only those, that move with presses at rest.
    fn pinned(&self, modes: Modes, _state: &[f64]) -> Modes {
        modes
    }

    /// Whether the field stands for the system at this place.
    ///
    /// # Errors
    /// A law is out of its bounds, or a one-directional smoothing is used backwards.
    fn check(&self, _at: &Place) -> Result<(), FlowError> {
        Ok(())
    }

    /// Friction forces and observables at a place.
    ///
    /// # Errors
    /// The forces are not determined there.
    fn read(&self, at: &Place) -> Result<Reading, FlowError>;

    /// All that is known of set-valued contacts at a place, each number with its slopes; of a smooth system, which has
    /// none, the field alone.
    ///
    /// # Errors
    /// The forces are not determined there.
    fn contacts(&self, at: &Place) -> Result<Contacts, FlowError>;

    /// The state with its phase between 0 and 2π.
    fn wrapped(&self, mut state: Vec<f64>) -> Vec<f64> {
        if let Some(index) = self.phase() {
            state[index] = state[index].rem_euclid(TAU);
        }
        state
    }
}
