//! How the relative speeds of contacts depend on the states, and what a layer of friction therefore resolves.

use std::borrow::Cow;

use num_dual::Dual64;

use super::SmoothField;
use super::rules::Speeds;
use crate::field::Strip;
use crate::field::generic::{GENERIC, generic_state};
use crate::field::strip::rows;
use crate::integrate::Tolerance;
use crate::model::Model;
use crate::scalar::{Inline, filled};

impl<M: Model<N>, const N: usize> SmoothField<M, N> {
    /// w_y of each contact.
    #[inline]
    fn gradients(&self, y: &[f64; N]) -> Cow<'_, M::PerContact<Strip<N>>> {
        match &self.gradients {
            Some(constant) => Cow::Borrowed(constant),
            None => Cow::Owned(gradients::<M, N>(&self.values, y)),
        }
    }

    /// What errors are measured against, tightened for each state that enters a sliding speed to what its layer resolves.
    #[inline]
    pub(super) fn layered(
        &self,
        mut scale: [f64; N],
        y: &[f64; N],
        tolerance: &Tolerance,
    ) -> [f64; N] {
        let width = 1.0 / self.rule.sharpness;
        let gradients = self.gradients(y);
        let gradients = gradients.as_ref().as_ref();
        self.speeds(y, |contact, speed| {
            let allowed = tolerance.absolute * width + tolerance.relative * speed.abs();
            for (j, slope) in gradients[contact].iter() {
                if slope != 0.0 {
                    scale[j] = scale[j].min(allowed / slope.abs());
                }
            }
        });
        scale
    }

    /// Rounding error of the relative speed of a contact, in widths of its layer.
    pub(super) fn rounding(&self, contact: usize, speed: f64, y: &[f64; N]) -> f64 {
        let gradients = self.gradients(y);
        let gradient = &gradients.as_ref().as_ref()[contact];
        let (mut moving, mut terms) = (0.0, 0.0);
        for (j, slope) in gradient.iter() {
            moving += slope * y[j];
            terms += (slope * y[j]).abs();
        }
        f64::EPSILON * (terms + (speed - moving).abs()) * self.rule.sharpness
    }
}

/// w_y of each contact at `y`.
fn gradients<M: Model<N>, const N: usize>(
    values: &M::Params<f64>,
    y: &[f64; N],
) -> M::PerContact<Strip<N>> {
    let params = Inline::from_fn(|i| Dual64::from(values.as_ref()[i]));
    rows::<M, N>(|unit| {
        let mut rates = M::PerContact::from_fn(|_| 0.0);
        let moving = filled(|i| Dual64::new(y[i], unit[i]));
        let mut visit = Speeds(|contact: usize, speed: Dual64| rates.as_mut()[contact] = speed.eps);
        let _ = M::rhs(&params, moving, &mut visit);
        rates
    })
}

/// w_y of each contact, if generic states have the same.
pub(super) fn constant<M: Model<N>, const N: usize>(
    values: &M::Params<f64>,
) -> Option<M::PerContact<Strip<N>>> {
    let at = GENERIC.map(|seed| gradients::<M, N>(values, &generic_state::<M, N>(seed)));
    (at[0].as_ref() == at[1].as_ref()).then_some(at[0])
}
