//! How the relative speeds of contacts depend on the states.

use std::borrow::Cow;

use num_dual::Dual64;

use super::rules::Speeds;
use crate::field::Strip;
use crate::field::generic::{GENERIC, generic_state};
use crate::field::strip::rows;
use crate::model::Model;
use crate::scalar::{Inline, filled};

/// w_y of each contact, if it is the same at every state.
#[derive(Clone, Copy)]
pub(super) struct Gradients<M: Model<N>, const N: usize>(Option<M::PerContact<Strip<N>>>);

impl<M: Model<N>, const N: usize> Gradients<M, N> {
    /// Those that generic states have in common; of a model without contacts none are asked for.
    pub(super) fn of(values: &M::Params<f64>) -> Self {
        if M::INFO.contacts.is_empty() {
            return Self(None);
        }
        let [first, second] = GENERIC.map(|seed| at::<M, N>(values, &generic_state::<M, N>(seed)));
        Self((first.as_ref() == second.as_ref()).then_some(first))
    }

    #[inline]
    fn at(&self, values: &M::Params<f64>, y: &[f64; N]) -> Cow<'_, M::PerContact<Strip<N>>> {
        match &self.0 {
            Some(constant) => Cow::Borrowed(constant),
            None => Cow::Owned(at::<M, N>(values, y)),
        }
    }

    /// What the error of each state is measured against, at most what is allowed of the speed that it enters.
    #[inline]
    pub(super) fn tightened(
        &self,
        mut scale: [f64; N],
        values: &M::Params<f64>,
        y: &[f64; N],
        allowed: impl Fn(f64) -> f64,
    ) -> [f64; N] {
        let gradients = self.at(values, y);
        let gradients = gradients.as_ref().as_ref();
        let mut tighten = Speeds(|contact: usize, speed| {
            let allowed = allowed(speed);
            for (j, slope) in gradients[contact].iter() {
                if slope != 0.0 {
                    scale[j] = scale[j].min(allowed / slope.abs());
                }
            }
        });
        let _ = M::rhs(values, *y, &mut tighten);
        scale
    }

    /// The magnitude of the terms of the relative speed of a contact: what its rounding error is measured against.
    pub(super) fn terms(
        &self,
        contact: usize,
        speed: f64,
        values: &M::Params<f64>,
        y: &[f64; N],
    ) -> f64 {
        self.at(values, y).as_ref().as_ref()[contact].terms(speed, y)
    }
}

/// w_y of each contact at `y`.
fn at<M: Model<N>, const N: usize>(
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
