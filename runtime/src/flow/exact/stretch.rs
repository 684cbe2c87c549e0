//! Stretches on which the field is linear: found once for each mode of the contacts.

use std::sync::{Arc, Mutex, PoisonError};

use super::forms::{Forms, forms};
use crate::field::exact::{ExactField, Modes};
use crate::integrate::Tolerance;
use crate::integrate::linear::{Blur, LinearFlow};
use crate::model::{Model, ModelInfo};

/// States up to which closed forms are cheaper than the integrator whatever the contacts do, and contacts and presses up to
/// which they are with more states, as a structure has: maps are found for each pattern of modes anew. Of a row of masses with
/// friction, once for each value of a parameter and with all derivatives, they are eight times as fast for 4 states and six
/// times for 12; a row of 10 costs the same either way, one of 20 three times as much. An orbit of a beam with 12 modes and
/// four contacts is found in a fourteenth of the time.
const SMALL: usize = 16;
const FEW: usize = 6;
/// Modes whose flows are kept; more are found anew each time.
const KEPT: usize = 64;

/// Whether exact motions of a model are followed in closed form between events: it is proven to be linear there, and small
/// or with few contacts.
pub(crate) fn in_closed_form(info: &ModelInfo) -> bool {
    let few = info.contacts.len() + info.presses.len() <= FEW;
    (few || info.states.len() <= SMALL) && info.is_linear()
}

/// The flows in closed form that were needed so far.
pub(super) struct Stretches<M: Model<N>, const N: usize>(Mutex<Vec<Stretch<M, N>>>);

/// The modes of a stretch, what may be off its dense output, and what is known of it, if it is linear.
type Stretch<M, const N: usize> = ((Modes<M, N>, Blur), Option<Arc<Known<M, N>>>);

/// A stretch in closed form.
pub(super) struct Known<M: Model<N>, const N: usize> {
    pub(super) flow: LinearFlow<N>,
    pub(super) guards: Forms<M, N>,
}

impl<M: Model<N>, const N: usize> Stretches<M, N> {
    /// None needed yet; `None` if the model is not proven to be linear, or has too many contacts.
    pub(super) fn of_model() -> Option<Self> {
        in_closed_form(M::INFO).then(|| Self(Mutex::default()))
    }

    /// The stretch of a field in closed form, if it has one.
    pub(super) fn along(
        &self,
        field: &ExactField<'_, M, N>,
        (tolerance, blur): (Tolerance, Blur),
    ) -> Option<Arc<Known<M, N>>> {
        self.find((*field.modes(), blur), || {
            let guards = forms(field.system(), field.modes())?;
            let flow = LinearFlow::new(field.linear()?, tolerance, blur)?;
            Some(Arc::new(Known { flow, guards }))
        })
    }

    fn find(
        &self,
        stretch: (Modes<M, N>, Blur),
        make: impl FnOnce() -> Option<Arc<Known<M, N>>>,
    ) -> Option<Arc<Known<M, N>>> {
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, flow)) = kept.iter().find(|(known, _)| *known == stretch) {
            return flow.clone();
        }
        let flow = make();
        if kept.len() < KEPT {
            kept.push((stretch, flow.clone()));
        }
        flow
    }
}
