//! Step lengths before a landing: beyond the surface a law is only continued, and a step that goes far
//! there is rejected anyway.

use super::ExactFlow;
use super::run::Run;
use super::steps::Steps;
use crate::field::exact::{Mode, Modes};
use crate::model::Model;

/// Part of the predicted time to the surface by which a step may go further.
const OVERSHOOT: f64 = 1.02;
/// Part of the length that the integrator proposes below which no prediction shortens a step.
const SHORTEST: f64 = 0.1;
/// Part of the longest step so far below which no step is shortened where a force has a root, whose derivatives err by the
/// power 3/2 of the first step.
const FINEST: f64 = 1e-6;
/// Part of the time until a gap opens that such a step may last.
const GRADED: f64 = 0.5;

impl<'f, M: Model<N>, const N: usize> Run<'f, M, N> {
    /// The longest step worth trying: a little beyond the predicted stop of any sliding contact.
    pub(super) fn approach(
        &mut self,
        stepper: &Steps<'_, 'f, M, N>,
        speeds: &M::PerContact<f64>,
    ) -> f64 {
        let (system, mut limit) = (&self.flow.system, f64::INFINITY);
        if const { Modes::<M, N>::PRESSED } {
            limit = self.graded(stepper);
        }
        let (Some(gradients), Some((proposal, slope))) = (system.gradients(), stepper.proposal())
        else {
            return limit;
        };
        let (rates, length) = &mut self.rates;
        let modes = self.modes.as_slice().iter().enumerate();
        for (i, mode) in modes.filter(|(i, _)| system.is_straight(*i) && !system.is_idle(*i)) {
            let sign = mode.sign();
            if sign == 0.0 {
                // Where it sets off again, it does so from rest.
                rates.as_mut()[i] = 0.0;
                continue;
            }
            let rate = sign * gradients[i].dot(slope);
            let bend = (rate - rates.as_ref()[i]) / *length;
            rates.as_mut()[i] = rate;
            let time = first_zero(sign * speeds.as_ref()[i], rate, bend);
            limit = limit.min((OVERSHOOT * time).max(SHORTEST * proposal));
        }
        limit
    }
}

impl<'f, M: Model<N>, const N: usize> Run<'f, M, N> {
    /// The longest step while a press is closed whose force is no power series in its depth: as long as the time since
    /// its gap closed, or half of that until it opens, so that the roots there cost derivatives no digits.
    fn graded(&self, stepper: &Steps<'_, 'f, M, N>) -> f64 {
        let (system, mut limit) = (&self.flow.system, f64::INFINITY);
        for press in ExactFlow::<M, N>::presses() {
            if self.modes.as_slice()[press] != Mode::Closed || !system.is_rough(press) {
                continue;
            }
            let at = stepper.from();
            if let Ok(moving) = system.moving(at, &self.modes) {
                let gap = moving.speed.as_ref()[press];
                let time = (gap.re / gap.eps).abs();
                let share = if gap.eps < 0.0 { 1.0 } else { GRADED };
                limit = limit.min((share * time).max(FINEST * self.longest));
            }
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
