//! When an exact motion is given up, and what is said of it.

use super::run::{NO_TIME, Run};
use crate::flow::FlowError;
use crate::flow::saltation::Tracked;
use crate::integrate::IntegrationError;
use crate::model::Model;

/// Events that may follow each other within [`NO_TIME`] of the passage.
const CHATTER: u64 = 100;

impl<M: Model<N>, V: Tracked<N>, const N: usize> Run<'_, M, V, N> {
    /// Counts events that follow each other in no time.
    pub(super) fn count_chatter(&mut self, contact: usize) -> Result<(), FlowError> {
        let (events, since) = &mut self.chatter;
        if self.time - *since > NO_TIME * self.span {
            (*events, *since) = (0, self.time);
        }
        *events += 1;
        if *events > CHATTER {
            return Err(FlowError::Chattering {
                contact,
                time: self.time,
                events: *events,
            });
        }
        Ok(())
    }

    /// A failure of the integrator, or what caused it.
    pub(super) fn explain(&self, mut error: IntegrationError) -> FlowError {
        if let IntegrationError::TooManySteps { steps, .. } = &mut error {
            *steps += self.work.steps + self.work.rejected;
        }
        if let IntegrationError::NotFinite { .. } = error
            && let Err(cause) = self.flow.system.snapshot(self.carried.state(), &self.modes)
        {
            return cause.into();
        }
        error.into()
    }
}
