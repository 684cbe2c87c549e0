//! Counted work: the machine-independent cost of a result.

use std::ops::AddAssign;

use borsh::{BorshDeserialize, BorshSerialize};

/// What a computation cost, in counts that do not depend on the machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, BorshSerialize, BorshDeserialize)]
pub struct Work {
    /// Accepted integration steps.
    pub steps: u64,
    /// Rejected integration steps.
    pub rejected: u64,
    /// Evaluations of f alone.
    pub evaluations: u64,
    /// Evaluations of f with its derivatives.
    pub linearisations: u64,
    /// LU factorisations in implicit steps.
    pub factorisations: u64,
    /// Events located.
    pub events: u64,
    /// Newton iterations of shooting and continuation.
    pub newton: u64,
}

impl Work {
    /// What was done since an earlier count.
    #[must_use]
    pub fn since(&self, before: &Self) -> Self {
        Self {
            steps: self.steps - before.steps,
            rejected: self.rejected - before.rejected,
            evaluations: self.evaluations - before.evaluations,
            linearisations: self.linearisations - before.linearisations,
            factorisations: self.factorisations - before.factorisations,
            events: self.events - before.events,
            newton: self.newton - before.newton,
        }
    }
}

impl AddAssign for Work {
    fn add_assign(&mut self, other: Self) {
        self.steps += other.steps;
        self.rejected += other.rejected;
        self.evaluations += other.evaluations;
        self.linearisations += other.linearisations;
        self.factorisations += other.factorisations;
        self.events += other.events;
        self.newton += other.newton;
    }
}
