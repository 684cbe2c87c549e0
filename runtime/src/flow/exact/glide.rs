//! A motion that is held in its modes: what a contact that is grazed would do if nothing happened to it.

use std::ops::ControlFlow;

use super::ExactFlow;
use crate::field::Work;
use crate::field::exact::{ExactField, Mode, Modes};
use crate::flow::{Derivatives, Flow, FlowError, Place};
use crate::integrate::Motion;
use crate::integrate::explicit::integrate;
use crate::model::Model;

impl<M: Model<N>, const N: usize> ExactFlow<M, N> {
    /// The motion from `from` for the time `time`, in the mode in which it begins whatever its guards say.
    pub(crate) fn glide(
        &self,
        from: &Place<N, Modes<M, N>>,
        time: f64,
    ) -> Result<(Place<N, Modes<M, N>>, Derivatives<N>), FlowError> {
        let field = ExactField::new(&self.system, from.mode, &from.state)?;
        let start = Motion::from(from.state);
        let mut work = Work::default();
        let motion = if time > 0.0 {
            integrate(&field, self.settings, start, time, &mut work, |_| {
                ControlFlow::Continue(())
            })?
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
            trace: motion.trace,
            factors: Vec::new(),
            lost: 0,
        };
        Ok((end, derivatives))
    }

    /// The relative speed of a contact the way it slides in this mode, and its rate; `None` if there is
    /// no such contact, or it sticks.
    pub(crate) fn touch(
        &self,
        at: &Place<N, Modes<M, N>>,
        contact: usize,
    ) -> Result<Option<[f64; 2]>, FlowError> {
        let mode = at.mode.as_slice().get(contact).copied();
        let Some(mode) = mode.filter(|mode| *mode != Mode::Stick) else {
            return Ok(None);
        };
        let moving = self.system.moving(&at.state, &at.mode)?;
        let speed = moving.speed.as_ref()[contact] * mode.sign();
        Ok(Some([speed.re, speed.eps]))
    }
}
