//! What an orbit is looked for from.

use super::division::Division;
use super::pin::Pin;
use crate::motion::Place;

/// A place near a periodic orbit.
#[derive(Debug, Clone, PartialEq)]
pub struct Guess {
    /// On the section where the first state is least, or where the phase of the drive begins.
    pub place: Place,
    /// Time to come back.
    pub period: f64,
    /// Half the extent of each state on the way.
    pub magnitude: Vec<f64>,
    /// What is held in neutral directions.
    pub pins: Vec<Pin>,
    /// What the states gain once around where the motion runs on: a shift that changes nothing.
    pub shift: Option<Vec<f64>>,
    /// The segments of an orbit along which errors grow much; the first begins at the place.
    pub division: Option<Division>,
}

impl Guess {
    /// This share of the magnitude of each state.
    pub(super) fn shares(&self, share: f64) -> Vec<f64> {
        self.magnitude.iter().map(|size| share * size).collect()
    }
}
