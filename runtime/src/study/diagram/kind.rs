//! Kinds of motions.

use serde::{Deserialize, Serialize};

/// The kind of a motion, as far as its points on a section tell.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub enum Motion {
    /// It comes back after this many points; of a driven system, after this many turns of its drive.
    Periodic(usize),
    /// It has not come back within half of the points taken.
    Aperiodic,
    /// It has not come back, but comes ever nearer to it.
    Settling,
    /// It rests.
    Rest,
    /// It moves, but does not meet the section.
    Elsewhere,
    /// It could not be followed; why.
    Failed(String),
}

impl Motion {
    /// In a word or two: `period-3`, `aperiodic`, `settling`, `rest`, `elsewhere`, `failed`.
    #[must_use]
    pub fn name(&self) -> String {
        match self {
            Self::Periodic(count) => format!("period-{count}"),
            Self::Aperiodic => "aperiodic".to_owned(),
            Self::Settling => "settling".to_owned(),
            Self::Rest => "rest".to_owned(),
            Self::Elsewhere => "elsewhere".to_owned(),
            Self::Failed(_) => "failed".to_owned(),
        }
    }
}
