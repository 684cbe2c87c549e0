//! Why a copy, or an orbit at a loose tolerance, is not measured.

use crate::continuation::{Failure, Stop};
use crate::flow::FlowError;
use crate::shooting::OrbitError;

/// Why a setting has no place in a trade.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(super) enum Lost {
    /// No orbit was found with it.
    #[error(transparent)]
    Orbit(#[from] OrbitError),
    /// Its motion cannot be followed.
    #[error(transparent)]
    Flow(#[from] FlowError),
    /// It cannot be followed in its size.
    #[error(transparent)]
    Branch(#[from] Failure<FlowError>),
    /// Its orbit is another one: it goes around more often, or less.
    #[error("the copy's orbit crosses the section {found} times instead of {wanted}")]
    Crossings {
        /// How often it crosses the section.
        found: usize,
        /// How often the exact orbit does.
        wanted: usize,
    },
    /// Its orbit is another one: its period is too far off.
    #[error("only another orbit is near, {ratio:.3} times as long")]
    Longer {
        /// Its period over that of the exact orbit.
        ratio: f64,
    },
    /// Its orbit is another one: its extrema are too far off.
    #[error("it is off by {by:.1e}: another orbit")]
    Off {
        /// The largest relative difference.
        by: f64,
    },
    /// Its branch in the size of the smoothing does not reach it.
    #[error("the branch in its size ends at {size:.3e}: {}", because(.stop.as_ref()))]
    Ends {
        /// Where.
        size: f64,
        /// Why.
        stop: Option<Stop<FlowError>>,
    },
    /// No copy has the orbit.
    #[error("no copy has the orbit")]
    NoCopy,
    /// No tolerance suffices.
    #[error("no tolerance meets {accuracy:e}")]
    NoTolerance {
        /// The accuracy.
        accuracy: f64,
    },
    /// No size suffices.
    #[error("no size was found at which the errors fall to {goal:e}")]
    NoSize {
        /// What they should fall to.
        goal: f64,
    },
}

/// Why a branch in the size of a smoothing ends.
fn because(stop: Option<&Stop<FlowError>>) -> String {
    stop.map_or_else(|| "it was left there".to_owned(), Stop::to_string)
}
