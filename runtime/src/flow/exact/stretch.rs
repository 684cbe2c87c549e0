//! Stretches on which the field is linear: found once for each mode of the contacts.

use std::sync::{Arc, Mutex, PoisonError};

use crate::field::exact::{ExactField, Modes};
use crate::integrate::Tolerance;
use crate::integrate::linear::LinearFlow;
use crate::model::Model;

/// Modes whose flows are kept; more are found anew each time.
const KEPT: usize = 64;
/// Part of the steps allowed that a stretch in closed form may need: what takes more is left to the integrator, which
/// lengthens its steps where fast motions have died away.
const SHARE: f64 = 0.1;

/// The flows in closed form that were needed so far.
pub(super) struct Stretches<M: Model<N>, const N: usize>(Mutex<Vec<Stretch<M, N>>>);

/// The modes of a stretch, and its flow, if there is one.
type Stretch<M, const N: usize> = (Modes<M, N>, Option<Arc<LinearFlow<N>>>);

impl<M: Model<N>, const N: usize> Stretches<M, N> {
    /// None needed yet; `None` if the model is not proven to be linear.
    pub(super) fn of_model() -> Option<Self> {
        M::INFO.is_linear().then(|| Self(Mutex::default()))
    }

    /// The flow of a field in closed form, if so many steps are more than enough for this time.
    pub(super) fn along(
        &self,
        field: &ExactField<'_, M, N>,
        tolerance: Tolerance,
        (span, steps): (f64, u64),
    ) -> Option<Arc<LinearFlow<N>>> {
        let found = self.find(field.modes(), || {
            LinearFlow::new(field.linear()?, tolerance).map(Arc::new)
        })?;
        let needed = span / found.longest();
        (needed <= SHARE * steps as f64).then_some(found)
    }

    fn find(
        &self,
        modes: &Modes<M, N>,
        make: impl FnOnce() -> Option<Arc<LinearFlow<N>>>,
    ) -> Option<Arc<LinearFlow<N>>> {
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, flow)) = kept.iter().find(|(known, _)| known == modes) {
            return flow.clone();
        }
        let flow = make();
        if kept.len() < KEPT {
            kept.push((*modes, flow.clone()));
        }
        flow
    }
}
