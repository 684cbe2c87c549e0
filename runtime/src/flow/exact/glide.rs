//! A motion that is held in its modes: what a contact that is grazed would do if nothing happened to it.

use std::ops::ControlFlow;

use super::ExactFlow;
use crate::field::Work;
use crate::field::exact::{ExactField, Mode, Modes};
use crate::flow::{Derivatives, Flow, FlowError, Place, SmoothFlow, Want};
use crate::integrate::Motion;
use crate::integrate::explicit::integrate;
use crate::model::Model;

/// A flow that can be followed past the guards of its modes.
pub trait Glide<const N: usize>: Flow<N> {
    /// The motion from `from` for the time `time`, in the mode in which it begins whatever its guards say.
    ///
    /// # Errors
    /// The motion cannot be followed.
    fn glide(
        &self,
        from: &Place<N, Self::Mode>,
        time: f64,
    ) -> Result<(Place<N, Self::Mode>, Derivatives<N>), FlowError>;

    /// The relative speed of a contact the way it slides in this mode, and its rate; `None` if there is
    /// no such contact, or it sticks.
    ///
    /// # Errors
    /// The forces are not determined there.
    fn touch(
        &self,
        at: &Place<N, Self::Mode>,
        contact: usize,
    ) -> Result<Option<[f64; 2]>, FlowError>;
}

impl<M: Model<N>, const N: usize> Glide<N> for ExactFlow<M, N> {
    fn glide(
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

    fn touch(
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

/// Nothing switches: gliding is moving.
impl<M: Model<N>, const N: usize> Glide<N> for SmoothFlow<M, N> {
    fn glide(
        &self,
        from: &Place<N, ()>,
        time: f64,
    ) -> Result<(Place<N, ()>, Derivatives<N>), FlowError> {
        let want = Want {
            derivatives: true,
            ..Want::default()
        };
        let passage = self.advance(from, time, want)?;
        let derivatives = passage.derivatives.ok_or(FlowError::BadTime { time })?;
        Ok((passage.end, derivatives))
    }

    fn touch(&self, _at: &Place<N, ()>, _contact: usize) -> Result<Option<[f64; 2]>, FlowError> {
        Ok(None)
    }
}
