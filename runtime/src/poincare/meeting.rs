//! Where between two times a motion has a level.

use super::crossings::Crossings;
use crate::flow::{FlowError, Want};
use crate::motion::Place;

/// A state this close to a level, in units of its rounding, lies on it.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
const ITERATIONS: usize = 80;

impl Crossings<'_> {
    /// The time and state, between two times of the passage, at which the state comes to the level from below (`rise` = 1) or
    /// above (-1): by Newton's method on the motion itself, kept inside by halving. Of a motion that rests on the level before it goes on, its arrival.
    pub(super) fn meet(
        &mut self,
        (index, level, rise): (usize, f64, f64),
        from: f64,
        until: (f64, &[f64]),
    ) -> Result<(f64, Vec<f64>), FlowError> {
        let mut low = (from, self.place.clone());
        if from > 0.0 {
            low.1 = self.ahead(&low.1, from)?;
        }
        let lack = |state: &[f64]| state[index] - level;
        let (mut high, mut best) = (until.0, (until.0, until.1.to_vec()));
        let mut time = secant((low.0, lack(&low.1.state)), (high, lack(&best.1)));
        for _ in 0..ITERATIONS {
            if !(time > low.0 && time < high) {
                time = 0.5 * (low.0 + high);
            }
            if !(time > low.0 && time < high) {
                break;
            }
            let place = self.ahead(&low.1, time - low.0)?;
            let short = lack(&place.state);
            best = (time, place.state.clone());
            let slope = self.flow.velocity(&place)?.f[index];
            let arrived = side(&place.state, index, level) == 0.0;
            if arrived && slope != 0.0 {
                break;
            }
            if !arrived && short * rise < 0.0 {
                low = (time, place);
            } else {
                high = time;
            }
            time -= short / slope;
        }
        Ok(best)
    }

    fn ahead(&mut self, from: &Place, time: f64) -> Result<Place, FlowError> {
        let passage = self.flow.advance(from, time, Want::default())?;
        self.work += passage.work;
        Ok(passage.end)
    }
}

/// Sign of a state less a level, 0 within rounding.
pub(super) fn side(state: &[f64], index: usize, level: f64) -> f64 {
    let lack = state[index] - level;
    if lack.abs() <= ROUNDING * state[index].abs().max(level.abs()) {
        0.0
    } else {
        lack.signum()
    }
}

fn secant(low: (f64, f64), high: (f64, f64)) -> f64 {
    low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1)
}
