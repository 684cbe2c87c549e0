//! Counted work as JSON.

use crate::field::Work;

/// Counted work.
#[derive(serde::Serialize)]
pub(super) struct Counts {
    steps: u64,
    rejected: u64,
    evaluations: u64,
    linearisations: u64,
    factorisations: u64,
    events: u64,
    newton: u64,
}

impl From<&Work> for Counts {
    fn from(work: &Work) -> Self {
        Self {
            steps: work.steps,
            rejected: work.rejected,
            evaluations: work.evaluations,
            linearisations: work.linearisations,
            factorisations: work.factorisations,
            events: work.events,
            newton: work.newton,
        }
    }
}
