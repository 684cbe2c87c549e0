//! Points of a motion on a section, and how a section is spelt.

use super::case::Case;
use super::error::StudyError;
use super::system::System;
use crate::flow::FlowError;
use crate::model::ModelInfo;
use crate::motion::Flow;
use crate::poincare::{Crossing, Section, Surface, once_around, until};

/// How long a motion is watched.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Span {
    /// For this time; a start on the section does not count.
    Time(f64),
    /// Once around a periodic orbit of this period: each of its points counts once.
    Period(f64),
}

impl Span {
    fn crossings(
        self,
        flow: &dyn Flow,
        start: &[f64],
        section: Section,
    ) -> Result<Vec<Crossing>, FlowError> {
        let place = flow.place(start)?;
        match self {
            Self::Time(time) => until(flow, place, section, time),
            Self::Period(period) => once_around(flow, place, section, period),
        }
    }
}

impl System {
    /// The points at which the motion from the start of the case meets a section.
    ///
    /// # Errors
    /// The motion cannot be followed.
    pub fn crossings(
        &self,
        case: &Case,
        section: Section,
        span: Span,
    ) -> Result<Vec<Crossing>, StudyError> {
        let flow = self.at(case)?;
        Ok(span.crossings(flow.as_ref(), &self.start(case), section)?)
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
