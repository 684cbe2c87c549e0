//! Step lengths before a landing: beyond the surface a law is only continued, and a step that goes far
//! there is rejected anyway.

use super::run::{Run, Steps};
use crate::flow::saltation::Tracked;
use crate::model::Model;

/// Part of the predicted time to the surface by which a step may go further.
const OVERSHOOT: f64 = 1.02;
/// Part of the length that the integrator proposes below which no prediction shortens a step.
const SHORTEST: f64 = 0.1;

impl<'f, M: Model<N>, V: Tracked<N>, const N: usize> Run<'f, M, V, N> {
    /// The longest step worth trying: a little beyond the predicted stop of any sliding contact.
    pub(super) fn approach(&mut self, stepper: &Steps<'_, 'f, M, V, N>) -> f64 {
        let (system, mut limit) = (&self.flow.system, f64::INFINITY);
        let (Some(gradients), Some(proposal)) = (system.gradients(), stepper.proposal()) else {
            return limit;
        };
        let speeds = system.speeds(stepper.from().state());
        let (rates, length) = &mut self.rates;
        let modes = self.modes.as_slice().iter().enumerate();
        for (i, mode) in modes.filter(|(i, _)| system.is_straight(*i) && !system.is_idle(*i)) {
            let rate = mode.sign() * gradients[i].dot(stepper.from_slope().state());
            let bend = (rate - rates.as_ref()[i]) / *length;
            rates.as_mut()[i] = rate;
            let time = first_zero(mode.sign() * speeds.as_ref()[i], rate, bend);
            limit = limit.min((OVERSHOOT * time).max(SHORTEST * proposal));
        }
        limit
    }
}

/// The first t > 0 at which value + rate t + bend t²/2 vanishes, value being positive.
fn first_zero(value: f64, rate: f64, bend: f64) -> f64 {
    let discriminant = rate * rate - 2.0 * bend * value;
    let time = 2.0 * value / (discriminant.sqrt() - rate);
    if value > 0.0 && time > 0.0 {
        time
    } else {
        f64::INFINITY
    }
}
