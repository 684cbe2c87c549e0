//! Layers that a step goes through without feeling them.

use super::SmoothFlow;
use crate::field::SmoothField;
use crate::flow::FlowError;
use crate::integrate::explicit::Stepper;
use crate::integrate::{Accepted, Carried};
use crate::model::Model;

impl<M: Model<N>, const N: usize> SmoothFlow<M, N> {
    /// Whether a step has gone through a layer and back without feeling it: friction would add energy.
    pub(super) fn jumps<const S: usize>(&self, step: &Accepted<N, S>) -> bool {
        let along = |theta| step.inside(theta);
        (!M::INFO.contacts.is_empty() && self.field.dips(&along))
            || (!M::INFO.presses.is_empty() && self.field.touches(&along).is_some())
    }

    /// Ends an explicit step where a press sets in that it has not felt, because it lets go before the end.
    pub(super) fn feel<V: Carried<N>>(
        &self,
        step: &mut Stepper<'_, SmoothField<M, N>, V, N>,
    ) -> Result<(), FlowError> {
        if M::INFO.presses.is_empty() {
            return Ok(());
        }
        let dense = step.dense();
        if let Some(theta) = self.field.touches(&|theta| dense.state(theta)) {
            step.shorten(theta * step.length())?;
            step.stop_at_corner()?;
        }
        Ok(())
    }
}
