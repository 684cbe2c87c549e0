//! A motion that is held in its modes: what a contact that is grazed would do if nothing happened to it.

use std::ops::ControlFlow;

use super::ExactFlow;
use crate::field::Work;
use crate::field::exact::{ExactField, Mode, Modes};
use crate::flow::{Derivatives, Determinant, Flow, FlowError, Place};
use crate::integrate::explicit::integrate;
use crate::integrate::linear::Blur;
use crate::integrate::{Carried, IntegrationError, Motion};
use crate::model::Model;

impl<M: Model<N>, const N: usize> ExactFlow<M, N> {
    /// The motion from `from` for the time `time`, in the mode in which it begins whatever its guards say; what sticks does so
    /// from the beginning on.
    pub(crate) fn glide(
        &self,
        from: &Place<N, Modes<M, N>>,
        time: f64,
    ) -> Result<(Place<N, Modes<M, N>>, Derivatives<N>), FlowError> {
        let field = ExactField::new(&self.system, from.mode, &from.state)?;
        let mut start = Motion::from(from.state);
        self.put_on_surface(&mut start, &from.mode)?;
        let motion = if time > 0.0 {
            self.held(&field, start, time)?
        } else {
            start
        };
        let end = Place {
            state: motion.state,
            mode: from.mode,
        };
        let derivatives = Derivatives {
            state: motion.tangent,
            design: motion.design,
            time: self.velocity(&end)?.f,
            determinant: Determinant::grown(motion.trace),
            factors: Vec::new(),
            lost: 0,
        };
        Ok((end, derivatives))
    }

    /// The motion along this field this time later: in closed form where it is linear.
    fn held(
        &self,
        field: &ExactField<'_, M, N>,
        start: Motion<N>,
        time: f64,
    ) -> Result<Motion<N>, FlowError> {
        let sharp = (self.settings.tolerance, Blur::Coarse);
        let linear = self.stretches.as_ref();
        if let Some(known) = linear.and_then(|stretches| stretches.along(field, sharp)) {
            let motion = known.flow.after(start, time);
            if motion.is_finite() {
                return Ok(motion);
            }
            return Err(FlowError::Integration(IntegrationError::NotFinite {
                time,
                state: motion.state.to_vec().into(),
            }));
        }
        let mut work = Work::default();
        let motion = integrate(field, self.settings, start, time, &mut work, |_| {
            ControlFlow::Continue(())
        });
        Ok(motion?)
    }

    /// What ends the mode of a contact where it falls through zero, and its rate: the relative speed the way it slides, or
    /// what the force of one that sticks lacks to its limit; `None` if there is no such contact.
    pub(crate) fn touch(
        &self,
        at: &Place<N, Modes<M, N>>,
        contact: usize,
    ) -> Result<Option<[f64; 2]>, FlowError> {
        let Some(mode) = at.mode.as_slice().get(contact).copied() else {
            return Ok(None);
        };
        let moving = self.system.moving(&at.state, &at.mode)?;
        let force = moving.force.as_ref()[contact];
        let guard = match mode {
            Mode::Rest => moving.stick.as_ref()[contact],
            Mode::Stick => moving.stick.as_ref()[contact] - force * force.re.signum(),
            _ => moving.speed.as_ref()[contact] * mode.sign(),
        };
        Ok(Some([guard.re, guard.eps]))
    }

    /// What keeps a press closed while it is positive, or lets it go while it is negative, the way its mode needs it, and its
    /// rate; `None` if there is no such press, or it does not give way.
    pub(crate) fn hold(
        &self,
        at: &Place<N, Modes<M, N>>,
        contact: usize,
    ) -> Result<Option<[f64; 2]>, FlowError> {
        let way = match at.mode.as_slice().get(contact) {
            Some(Mode::Closed) => 1.0,
            Some(Mode::Parted) => -1.0,
            _ => return Ok(None),
        };
        let hold = self.system.moving(&at.state, &at.mode)?.stick.as_ref()[contact];
        Ok(Some([way * hold.re, way * hold.eps]))
    }

    /// By what share of its limit at rest the force of a contact drops where it lets go.
    pub(crate) fn loosening(&self, state: &[f64; N], contact: usize) -> f64 {
        let limits = self.system.limits_at_rest(state);
        let (stick, slip) = limits.as_ref().get(contact).copied().unwrap_or((1.0, 1.0));
        if stick > 0.0 {
            (stick - slip) / stick
        } else {
            0.0
        }
    }
}
