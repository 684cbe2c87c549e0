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

    /// This share of the way to the guess of a neighbour, where both begin alike.
    pub(super) fn towards(mut self, other: &Self, share: f64) -> Self {
        let whole = self.division.is_none() && self.pins.is_empty();
        if whole && self.place.modes == other.place.modes {
            let along = |from: f64, to: f64| from + share * (to - from);
            for (state, to) in self.place.state.iter_mut().zip(&other.place.state) {
                *state = along(*state, *to);
            }
            self.period = along(self.period, other.period);
        }
        self
    }
}

/// Magnitudes as far as a start shows them: that of its largest component where one is zero or next to it.
pub(super) fn magnitude_of(start: &[f64]) -> Vec<f64> {
    let largest = start.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let other = if largest > 0.0 { largest } else { 1.0 };
    let size = |x: &f64| {
        if x.abs() > 1e-3 * other {
            x.abs()
        } else {
            other
        }
    };
    start.iter().map(size).collect()
}
