//! How long a motion is watched, and how a section is spelt.

use crate::model::ModelInfo;
use crate::poincare::{Section, Surface};

/// How long a motion is watched.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Span {
    /// For this time; a start on the section does not count.
    Time(f64),
    /// Once around a periodic orbit of this period: each of its points counts once.
    Period(f64),
}

impl Section {
    /// As a user writes it: `der(x1)=0 up`.
    #[must_use]
    pub fn describe(&self, info: &ModelInfo) -> String {
        let name = |state: usize| info.states.get(state).map_or("", |state| state.name);
        let direction = self.direction.name();
        match self.surface {
            Surface::Rate(state) => format!("der({})=0 {direction}", name(state)),
            Surface::Level { state, value } => format!("{}={value} {direction}", name(state)),
        }
    }
}
