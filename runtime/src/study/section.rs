//! Points of a motion on a section, and how a section is spelt.

use crate::flow::{Flow, FlowError};
use crate::model::ModelInfo;
use crate::poincare::{Crossing, Section, Surface, once_around, until};

/// A point of a motion on a section, whatever model it belongs to.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "app", derive(serde::Serialize))]
pub struct CrossingRecord {
    /// When, from the beginning of the motion.
    pub time: f64,
    /// Whether the function that vanishes there grows.
    pub rising: bool,
    /// Where.
    pub state: Vec<f64>,
}

/// How long a motion is watched.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Span {
    /// For this time; a start on the section does not count.
    Time(f64),
    /// Once around a periodic orbit of this period: each of its points counts once.
    Period(f64),
}

impl Span {
    pub(super) fn crossings<F: Flow<N>, const N: usize>(
        self,
        flow: &F,
        start: [f64; N],
        section: Section,
    ) -> Result<Vec<CrossingRecord>, FlowError> {
        let place = flow.place(start)?;
        let found = match self {
            Self::Time(time) => until(flow, place, section, time)?,
            Self::Period(period) => once_around(flow, place, section, period)?,
        };
        Ok(found.iter().map(CrossingRecord::from).collect())
    }
}

impl<const N: usize> From<&Crossing<N>> for CrossingRecord {
    fn from(crossing: &Crossing<N>) -> Self {
        Self {
            time: crossing.time,
            state: crossing.state.to_vec(),
            rising: crossing.rising,
        }
    }
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
