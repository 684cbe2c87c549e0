//! A motion, followed passage by passage.

use crate::flow::{FlowError, Want};
use crate::motion::{Flow, Passage, Place};
use crate::poincare::{longest, radian};

/// Minima in a passage that suffice: it need not be longer.
const ENOUGH: usize = 2;
/// Steps in a passage that suffice.
const STEPS: u64 = 2000;
/// How long a passage can be at most, over the first one.
const MOST: f64 = 1e12;

pub(super) struct Pursuit<'f> {
    flow: &'f dyn Flow,
    pub(super) place: Place,
    pub(super) time: f64,
    pub(super) steps: u64,
    chunk: f64,
    longest: f64,
}

impl<'f> Pursuit<'f> {
    pub(super) fn new(flow: &'f dyn Flow, start: &[f64]) -> Result<Self, FlowError> {
        let place = flow.place(start)?;
        let chunk = radian(flow, &place)?;
        Ok(Self {
            chunk,
            longest: longest(flow, &place)?.min(MOST * chunk),
            flow,
            place,
            time: 0.0,
            steps: 0,
        })
    }

    /// The next passage; later ones are longer, until each holds a lap or two.
    pub(super) fn on(&mut self) -> Result<Passage, FlowError> {
        let passage = self.flow.advance(&self.place, self.chunk, Want::EXTREMA);
        let passage = passage.map_err(|error| error.later(self.time))?;
        let work = passage.work;
        self.steps += work.steps + work.rejected;
        self.time += self.chunk;
        self.place.clone_from(&passage.end);
        self.place.state = self.flow.wrapped(std::mem::take(&mut self.place.state));
        let most = (0..self.place.state.len()).map(|j| passage.minima(j).count());
        if most.max().unwrap_or(0) < ENOUGH && work.steps < STEPS {
            self.chunk = (2.0 * self.chunk).min(self.longest);
        }
        Ok(passage)
    }
}
