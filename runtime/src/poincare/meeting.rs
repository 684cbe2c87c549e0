//! Where between two times a motion has a level.

use crate::field::Work;
use crate::flow::{FlowError, Want};
use crate::motion::{Flow, Place};

/// A state this close to a level, in units of its rounding, lies on it.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
const ITERATIONS: usize = 80;

/// A motion that comes to a level.
pub(super) struct Meeting<'a> {
    pub(super) flow: &'a dyn Flow,
    /// Where the passage begins in which it does.
    pub(super) place: &'a Place,
    /// The state that has the level, and the level.
    pub(super) state: usize,
    pub(super) level: f64,
    /// Whether from below (1) or from above (-1).
    pub(super) rise: f64,
    pub(super) work: &'a mut Work,
}

impl Meeting<'_> {
    /// The time and state, between two times of the passage, at which the state comes to the level: by Newton's method
    /// on the motion itself, kept inside by halving. Of a motion that rests on the level before it goes on, its arrival.
    pub(super) fn between(
        mut self,
        from: f64,
        until: (f64, &[f64]),
    ) -> Result<(f64, Vec<f64>), FlowError> {
        let mut low = (from, self.place.clone());
        if from > 0.0 {
            low.1 = self.ahead(&low.1, from)?;
        }
        let (index, level) = (self.state, self.level);
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
            let slope = self.flow.velocity(&place)?.f[index];
            // A level of zero is met to what the time is rounded to.
            let rounded = short.abs() <= ROUNDING * slope.abs() * time;
            let arrived = rounded || side(&place.state, index, level) == 0.0;
            // Where an impact passes over the level, it is met behind that.
            let before = !arrived && short * self.rise < 0.0;
            if !before {
                (high, best) = (time, (time, place.state.clone()));
            }
            if arrived && slope != 0.0 {
                break;
            }
            if before {
                low = (time, place);
            }
            time -= short / slope;
        }
        Ok(best)
    }

    fn ahead(&mut self, from: &Place, time: f64) -> Result<Place, FlowError> {
        let passage = self.flow.advance(from, time, Want::default())?;
        *self.work += passage.work;
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
