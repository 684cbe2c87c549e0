//! The exact field: every contact slides one way or sticks, and a sticking force is what keeps its speed at zero.

mod affine;
mod closed;
mod columns;
mod constants;
mod error;
mod impact;
mod load;
mod loose;
mod mode;
mod pressed;
mod rest;
mod rule;
mod solve;
mod stuck;
mod system;
mod tied;
mod together;
mod twin;

use num_dual::Dual64;

use super::{Field, Linear, LinearField, memory};
use crate::integrate::Tolerance;
use crate::model::Model;
use crate::scalar::{Inline, Lanes, Scalar, mapped};
pub(crate) use affine::Snapshot;
pub(crate) use closed::Closed;
use constants::Constants;
pub use error::ContactError;
use error::opposing;
pub(crate) use impact::{Impact, Impulses};
pub use mode::{Mode, Modes};
use rule::Sliding;
pub(crate) use solve::solve;
pub use system::{ContactState, ExactSystem};
use together::Together;

/// Share of a contact's usual speed within which a law changes so fast that the tolerance of states is too coarse.
const THIN: f64 = 0.02;

/// The exact field while every contact keeps its mode.
pub struct ExactField<'s, M: Model<N>, const N: usize> {
    system: &'s ExactSystem<M, N>,
    modes: Modes<M, N>,
    /// Numbers of the contacts whose forces are solved for, in front.
    stuck: M::PerContact<usize>,
    sticking: usize,
    /// What does not depend on the state, if that is all that is asked for.
    constants: Option<&'s Constants<M, N>>,
    /// What contacts hold together then, if they do.
    together: Option<Box<Together<M, N>>>,
    /// Speeds within which sliding forces change, if any is so small that errors must be judged by it.
    layers: Option<M::PerContact<f64>>,
}

impl<'s, M: Model<N>, const N: usize> ExactField<'s, M, N> {
    /// The field of `system` in these modes.
    ///
    /// # Errors
    /// The sticking forces are not unique at `state`, or push the wrong way.
    pub fn new(
        system: &'s ExactSystem<M, N>,
        modes: Modes<M, N>,
        state: &[f64; N],
    ) -> Result<Self, ContactError> {
        let mut stuck: M::PerContact<usize> = Inline::from_fn(|_| 0);
        for (place, contact) in stuck.as_mut().iter_mut().zip(modes.bound()) {
            *place = contact;
        }
        let constants = system.constants_in(&modes);
        let together = match constants {
            Some(constants) => {
                opposing::<M, N>(&constants.compliance, &modes)?;
                constants.together(&modes)?
            }
            None => {
                system.snapshot(state, &modes)?;
                None
            }
        };
        let layers = system.layers(state);
        let usual = |i: usize| system.usual_speed(i);
        let thin = (layers.as_ref().iter().enumerate()).any(|(i, layer)| *layer < THIN * usual(i));
        Ok(Self {
            layers: thin.then_some(layers),
            system,
            sticking: modes.bound().count(),
            modes,
            stuck,
            constants,
            together,
        })
    }

    /// Its parts, if it is linear, which is for the model to say; `None` if they are no numbers.
    pub(crate) fn linear(&self) -> Option<LinearField<N>> {
        let design = self.system.is_designed();
        LinearField::of(self, M::INFO.drive, &self.system.magnitude, design)
    }

    /// The equations.
    pub(crate) fn system(&self) -> &'s ExactSystem<M, N> {
        self.system
    }

    /// The modes.
    #[must_use]
    pub fn modes(&self) -> &Modes<M, N> {
        &self.modes
    }

    /// Whether any contact sticks, or any press is at rest.
    #[must_use]
    pub fn sticks(&self) -> bool {
        self.sticking > 0
    }

    /// The field without the sticking forces, over any scalar.
    #[inline]
    fn free<D: Scalar>(&self, params: &M::Params<D>, state: [D; N]) -> [D; N] {
        M::rhs(
            params,
            state,
            &mut Sliding::<M, N>::new(self.modes.as_slice()),
        )
    }

    /// The derivatives without the sticking forces.
    #[inline(always)]
    fn linearise_free(&self, y: &[f64; N]) -> Linear<N> {
        let system = self.system;
        system.columns.linearise(
            |seed| {
                let state = crate::scalar::filled(|i| Dual64::new(y[i], seed[i]));
                self.free(&system.directional, state)
            },
            || self.free(&system.turned, mapped(y, Dual64::from)),
        )
    }
}

impl<M: Model<N>, const N: usize> Field<N> for ExactField<'_, M, N> {
    const KINEMATIC: [Option<usize>; N] = M::KINEMATIC;

    fn f(&self, y: &[f64; N]) -> [f64; N] {
        self.with_f(y, |f| f)
    }

    #[inline]
    fn with_f<R>(&self, y: &[f64; N], take: impl FnOnce([f64; N]) -> R) -> R {
        if self.sticks() {
            self.bound(y, take)
        } else {
            take(self.free(&self.system.plain, *y))
        }
    }

    /// A law that changes within a thin layer of speed tightens what its speed is measured against.
    fn scale(&self, y: &[f64; N], tolerance: &Tolerance) -> [f64; N] {
        let magnitude = &self.system.magnitude;
        let mut scale = crate::scalar::filled(|j| {
            tolerance.absolute * magnitude[j] + tolerance.relative * y[j].abs()
        });
        let (Some(layers), Some(gradients)) = (&self.layers, self.system.gradients()) else {
            return scale;
        };
        let speeds = self.system.speeds(y);
        for (i, gradient) in gradients.iter().enumerate() {
            let terms = gradient.iter().map(|(j, slope)| (slope * y[j]).abs());
            let speed = speeds.as_ref()[i].abs();
            let rounding = f64::EPSILON * (terms.sum::<f64>() + speed);
            let layer = (tolerance.absolute + tolerance.relative)
                * layers.as_ref()[i].min(self.system.usual_speed(i));
            let allowed = layer + tolerance.relative * speed + rounding;
            for (j, slope) in gradient.iter() {
                scale[j] = scale[j].min(allowed / slope.abs());
            }
        }
        scale
    }

    fn kinks(&self) -> usize {
        self.system.corners
    }

    fn corners(&self) -> usize {
        self.system.corners
    }

    fn kink(&self, index: usize, y: &[f64; N]) -> f64 {
        memory::corner::<M, N>(&self.system.plain, index, y)
    }

    fn linearise(&self, y: &[f64; N]) -> Linear<N> {
        self.with_linear(y, |linear| linear)
    }

    // Called, it costs a small model more than its formulas do.
    #[inline(always)]
    fn with_linear<R>(&self, y: &[f64; N], take: impl FnOnce(Linear<N>) -> R) -> R {
        if self.sticks() {
            self.linearise_bound(y, take)
        } else {
            take(self.linearise_free(y))
        }
    }
}

/// Values, Jacobian and design column out of the lanes.
pub(crate) fn linear_of<L: Lanes<N>, const N: usize>(field: &[L; N]) -> Linear<N> {
    let slopes: [_; N] = crate::scalar::filled(|i| field[i].slopes());
    Linear {
        f: crate::scalar::filled(|i| field[i].re()),
        jacobian: mapped(&slopes, |(state, _)| state),
        design: mapped(&slopes, |(_, design)| design),
    }
}

#[cfg(test)]
mod tests;
