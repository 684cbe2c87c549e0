//! Internal states that meet their stops and leave them: what a passage makes of it.

use std::borrow::Cow;

use super::record::Record;
use crate::field::{Caught, Settled, SmoothField};
use crate::flow::saltation::catch;
use crate::flow::{Factor, FlowError};
use crate::integrate::Motion;
use crate::model::Model;

/// Whether every stop stands somewhere.
///
/// # Errors
/// One does not: its bound is no finite number above 0.
pub(in crate::flow) fn check_stops<M: Model<N>, const N: usize>(
    field: &SmoothField<M, N>,
) -> Result<(), FlowError> {
    if !SmoothField::<M, N>::STOPS {
        return Ok(());
    }
    let Some((state, bound)) = field.stops().misplaced() else {
        return Ok(());
    };
    let owner = M::INFO
        .memories
        .iter()
        .find(|memory| memory.states.contains(&state));
    Err(FlowError::Misplaced {
        state: M::INFO.states[state].name,
        law: owner.map_or("", |memory| memory.law.name),
        bound,
    })
}

/// The field in the modes with which a motion sets out from `state`.
pub(super) fn settled<M: Model<N>, const N: usize>(
    field: &SmoothField<M, N>,
    mut state: [f64; N],
) -> Cow<'_, SmoothField<M, N>> {
    if SmoothField::<M, N>::STOPS {
        let settled = field.settled(&mut state);
        return Cow::Owned(field.resting(settled.stops));
    }
    Cow::Borrowed(field)
}

impl<const N: usize> Record<N> {
    /// The field while what rests now rests.
    pub(super) fn field<'f, M: Model<N>>(
        &self,
        field: &'f SmoothField<M, N>,
    ) -> Cow<'f, SmoothField<M, N>> {
        if SmoothField::<M, N>::STOPS {
            return Cow::Owned(field.resting(self.stops));
        }
        Cow::Borrowed(field)
    }

    /// Puts the start between its stops.
    pub(super) fn settle<M: Model<N>>(&mut self, field: &SmoothField<M, N>) {
        if SmoothField::<M, N>::STOPS {
            let settled = field.settled(&mut self.motion.state);
            for caught in settled.caught() {
                catch(&mut self.motion, caught);
            }
            self.take(&settled);
        }
    }

    /// Changes the modes where a guard has fallen at the end of a step.
    pub(super) fn switch<M: Model<N>>(
        &mut self,
        field: &SmoothField<M, N>,
        fallen: Option<usize>,
    ) -> bool {
        if !SmoothField::<M, N>::STOPS {
            return false;
        }
        let state = &mut self.motion.state;
        let Some(settled) = fallen.and_then(|index| field.switched(state, index)) else {
            return false;
        };
        for caught in settled.caught() {
            catch(&mut self.motion, caught);
            self.forget(caught);
        }
        self.take(&settled);
        self.work.events += 1;
        true
    }

    fn take(&mut self, settled: &Settled<N>) {
        self.stops = settled.stops;
        self.lost = self.lost.max(self.stops.resting());
    }

    /// The factor of Φ that a stop makes, where steps have factors of their own: those of the implicit method do.
    fn forget(&mut self, caught: Caught) {
        if self.want.factors && !self.factors.is_empty() {
            let mut projection = Motion::from(self.motion.state);
            catch(&mut projection, caught);
            self.factors.push(Factor {
                state: projection.tangent,
                growth: None,
            });
        }
    }
}
