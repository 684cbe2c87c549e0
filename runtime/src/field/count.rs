//! Counted work: the machine-independent cost of a result.

use std::ops::AddAssign;

use serde::{Deserialize, Serialize};

/// Counters with all that goes through each of them.
macro_rules! counters {
    ($($(#[doc = $doc:literal])* $counter:ident: $told:literal,)*) => {
        /// What a computation cost, in counts that do not depend on the machine.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
        pub struct Work {
            $($(#[doc = $doc])* pub $counter: u64,)*
        }

        impl Work {
            /// What was done since an earlier count.
            #[must_use]
            pub fn since(&self, before: &Self) -> Self {
                Self { $($counter: self.$counter - before.$counter,)* }
            }

            /// Each count with what was counted.
            pub fn counts(&self) -> impl Iterator<Item = (u64, &'static str)> {
                [$((self.$counter, $told),)*].into_iter()
            }
        }

        impl AddAssign for Work {
            fn add_assign(&mut self, other: Self) {
                $(self.$counter += other.$counter;)*
            }
        }
    };
}

impl Work {
    /// Whether it was done without an integrator: all motions in closed form, where derivatives were asked for.
    pub(crate) fn is_in_closed_form(&self) -> bool {
        self.linearisations == 0
    }
}

counters! {
    /// Accepted integration steps.
    steps: "steps",
    /// Rejected integration steps.
    rejected: "rejected",
    /// Evaluations of f alone; in closed form, of the way of a step.
    evaluations: "evaluations",
    /// Evaluations of f with its derivatives.
    linearisations: "linearisations",
    /// LU factorisations in implicit steps.
    factorisations: "factorisations",
    /// Events located.
    events: "events",
    /// Newton iterations of shooting and continuation.
    newton: "Newton iterations",
}
