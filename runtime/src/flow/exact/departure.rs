//! How contacts leave the surface on which they were at rest (3.3).

use super::settle::{Rest, Verdict};
use crate::field::exact::Mode;
use crate::flow::FlowError;
use crate::model::Model;

/// Rate of a speed, relative to what friction can do, below which the next derivative decides.
const NO_RATE: f64 = 1e-12;
/// The same where the rate is known to vanish but for rounding errors.
const ROUNDED_RATE: f64 = 1e-9;

impl<M: Model<N>, const N: usize> Rest<'_, M, N> {
    /// The first derivative of w that does not vanish must have the sign of the new mode (3.3).
    pub(super) fn judge_departures(
        &self,
        verdict: &mut Verdict<M, N>,
        tangential: &M::PerContact<bool>,
    ) -> Result<(), FlowError> {
        let slides = |i: &usize| verdict.modes.as_slice()[*i] != Mode::Stick;
        let leaving: Vec<usize> = self.contacts().filter(slides).collect();
        if leaving.is_empty() {
            return Ok(());
        }
        let moving = self.system.moving(&self.state, &verdict.modes)?;
        let second = self
            .system
            .second_rates(&self.state, &verdict.modes, &moving.field);
        let able_under = self.all_stick();
        let able = self.system.affine(&self.state, &able_under);
        for contact in leaving {
            let mode = verdict.modes.as_slice()[contact];
            let compliance = able.compliance.as_ref()[contact].as_ref()[contact];
            let stick = if able_under.rests() {
                moving.stick.as_ref()[contact].re
            } else {
                able.stick.as_ref()[contact]
            };
            let scale = compliance * (stick + verdict.notes.as_ref()[contact].margin.abs());
            let rate = moving.speed.as_ref()[contact].eps;
            let second_rate = second.as_ref()[contact];
            let threshold = if tangential.as_ref()[contact] {
                ROUNDED_RATE
            } else {
                NO_RATE
            };
            let flat = rate.abs() <= threshold * scale;
            let (order, decisive) = if flat { (2, second_rate) } else { (1, rate) };
            if mode.sign() * decisive <= 0.0 || !decisive.is_finite() {
                return Err(FlowError::InconsistentMode {
                    contact: M::INFO.contact_id(contact),
                    time: self.time,
                    mode,
                    speed: moving.speed.as_ref()[contact].re,
                    rate,
                    second_rate,
                });
            }
            verdict.notes.as_mut()[contact].departure = order;
        }
        Ok(())
    }
}
