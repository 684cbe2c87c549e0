//! Whether the laws of a smooth motion hold where it is.

use super::SmoothFlow;
use crate::flow::FlowError;
use crate::flow::reach::{beyond, leaves};
use crate::model::Model;

impl<M: Model<N>, const N: usize> SmoothFlow<M, N> {
    /// Whether all laws hold at a state.
    ///
    /// # Errors
    /// A field of a law is out of its bounds there.
    pub(crate) fn within_laws(&self, state: [f64; N]) -> Result<(), FlowError> {
        let found = beyond::<M, N>(self.field.values(), state);
        found.map_or(Ok(()), |found| Err(FlowError::beyond(&found, 0.0, &state)))
    }

    /// Whether all laws hold along a step of this length from this time.
    pub(super) fn keep_laws(
        &self,
        (time, length): (f64, f64),
        at: &dyn Fn(f64) -> [f64; N],
    ) -> Result<(), FlowError> {
        let left = leaves::<M, N>(self.field.values(), at);
        left.map_or(Ok(()), |(theta, found)| {
            Err(FlowError::beyond(&found, time + theta * length, &at(theta)))
        })
    }
}
