//! Where on its orbit shooting had better begin.

use nalgebra::DVector;

use super::problem::OrbitProblem;
use super::shot::Shot;
use crate::flow::FlowError;
use crate::motion::{Place, Velocity};

/// A start is left for a calmer one whose field turns this many times more slowly.
const HASTE: f64 = 4.0;
/// Share of the period by which a start keeps away from events.
const MARGIN: f64 = 0.01;

impl OrbitProblem {
    /// A place on the orbit where Newton has it much easier than at the present start, if there is one.
    ///
    /// Shooting from a fast stretch makes the end bend strongly with the period; from just before
    /// an event, the start would leave its mode as r changes.
    pub(super) fn calmer(&self, r: f64, shot: &Shot) -> Result<Option<Place>, FlowError> {
        let [passage] = shot.passages.as_slice() else {
            return Ok(None);
        };
        // What is held at the start may change along the orbit; where that runs on, it may be held anywhere.
        if self.shift.is_none() && self.pins.iter().any(|pin| !pin.conserved()) {
            return Ok(None);
        }
        let flow = self.family.at(r)?;
        let mut place = passage.calm.place.clone();
        place.state = flow.wrapped(place.state);
        let haste = |velocity: &Velocity| {
            let bend = &velocity.jacobian * &velocity.f;
            let squares = |rates: &DVector<f64>| {
                let scaled = rates.iter().zip(&self.magnitude).map(|(v, unit)| v / unit);
                scaled.map(|v| v * v).sum::<f64>()
            };
            (squares(&bend) / squares(&velocity.f)).sqrt()
        };
        let there = flow.velocity(&place)?;
        let hasty = haste(&shot.velocity) > HASTE * haste(&there).max(1.0 / shot.period);
        Ok((hasty || shot.switches_near(0.0, MARGIN)).then_some(place))
    }
}
