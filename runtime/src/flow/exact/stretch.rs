//! Stretches on which the field is linear: found once for each mode of the contacts.

use std::sync::{Arc, Mutex, PoisonError};

use crate::field::exact::{ExactField, Modes};
use crate::integrate::Tolerance;
use crate::integrate::linear::{Blur, LinearFlow};
use crate::model::{Model, ModelInfo};

/// States up to which closed forms are cheaper than the integrator: of a row of masses with friction, once for each value of
/// a parameter and with all derivatives, eight times for 4 states and six times for 12, as their maps are found for each
/// pattern of modes anew.
const LARGEST: usize = 16;
/// Modes whose flows are kept; more are found anew each time.
const KEPT: usize = 64;
/// Part of the steps allowed that a stretch in closed form may need: what takes more is left to the integrator, which
/// lengthens its steps where fast motions have died away.
const SHARE: f64 = 0.1;

/// Whether exact motions of a model are followed in closed form between events: it is proven to be linear there, and small.
pub(crate) fn in_closed_form(info: &ModelInfo) -> bool {
    info.states.len() <= LARGEST && info.is_linear()
}

/// The flows in closed form that were needed so far.
pub(super) struct Stretches<M: Model<N>, const N: usize>(Mutex<Vec<Stretch<M, N>>>);

/// The modes of a stretch, what may be off its dense output, and its flow, if there is one.
type Stretch<M, const N: usize> = ((Modes<M, N>, Blur), Option<Arc<LinearFlow<N>>>);

impl<M: Model<N>, const N: usize> Stretches<M, N> {
    /// None needed yet; `None` if the model is not proven to be linear, or is large.
    pub(super) fn of_model() -> Option<Self> {
        in_closed_form(M::INFO).then(|| Self(Mutex::default()))
    }

    /// The flow of a field in closed form, if so many steps are more than enough for this time.
    pub(super) fn along(
        &self,
        field: &ExactField<'_, M, N>,
        (tolerance, blur): (Tolerance, Blur),
        (span, steps): (f64, u64),
    ) -> Option<Arc<LinearFlow<N>>> {
        let found = self.find((*field.modes(), blur), || {
            LinearFlow::new(field.linear()?, tolerance, blur).map(Arc::new)
        })?;
        let needed = span / found.longest();
        (needed <= SHARE * steps as f64).then_some(found)
    }

    fn find(
        &self,
        stretch: (Modes<M, N>, Blur),
        make: impl FnOnce() -> Option<Arc<LinearFlow<N>>>,
    ) -> Option<Arc<LinearFlow<N>>> {
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
