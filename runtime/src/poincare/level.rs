//! Where a state crosses a level, passage after passage.

use super::crossing::Crossing;
use super::meeting::{Meeting, side};
use crate::field::Work;
use crate::flow::FlowError;
use crate::motion::{Flow, Passage, Place};

/// A level of a state, and on which side of it a motion is.
pub(super) struct Level {
    state: usize,
    value: f64,
    /// Sign of the state less the level where it was last not zero.
    side: f64,
    /// When and where it has come to the level, as long as it has not left it.
    arrived: Option<(f64, Vec<f64>)>,
}

impl Level {
    pub(super) fn from(place: &Place, state: usize, value: f64) -> Self {
        Self {
            state,
            value,
            side: side(&place.state, state, value),
            arrived: None,
        }
    }

    /// The crossings in a passage of this length that begins at `place` and `start`. Between its extrema the state is
    /// monotonic: it meets a level at most once.
    pub(super) fn crossings(
        &mut self,
        flow: &dyn Flow,
        (place, start): (&Place, f64),
        (passage, length): (&Passage, f64),
        work: &mut Work,
    ) -> Result<Vec<Crossing>, FlowError> {
        let (state, level) = (self.state, self.value);
        let extrema = passage.extrema.iter().filter(|e| e.index == state);
        let turns = extrema.map(|extremum| (extremum.time, &extremum.state));
        let (mut found, mut from) = (Vec::new(), 0.0);
        for (until, there) in turns.chain([(length, &passage.end.state)]) {
            let side = side(there, state, level);
            if side * self.side <= 0.0 && self.arrived.is_none() && self.side != 0.0 {
                let meeting = Meeting {
                    flow,
                    place,
                    state,
                    level,
                    rise: -self.side,
                    work,
                };
                let (time, there) = meeting.between(from, (until, there))?;
                self.arrived = Some((start + time, there));
            }
            if side == 0.0 {
                continue;
            }
            if let (Some((time, state)), true) = (self.arrived.take(), side != self.side) {
                found.push(Crossing {
                    time,
                    rising: side > 0.0,
                    state,
                });
            }
            self.side = side;
            from = until;
        }
        Ok(found)
    }
}
