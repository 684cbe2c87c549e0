//! Points of a motion on a section.

use super::follow::measured;
use crate::poincare::{Met, Section, once_around, until};
use crate::study::error::StudyError;
use crate::study::question::{Case, Span};
use crate::study::system::System;

impl System {
    /// The points at which the motion from the start of the case meets a section, and how far it went meanwhile.
    ///
    /// # Errors
    /// The motion cannot be followed.
    pub fn crossings(&self, case: &Case, section: Section, span: Span) -> Result<Met, StudyError> {
        let family = self.family(case);
        let (Span::Time(time) | Span::Period(time)) = span;
        let from = (&*self.start(case), &*case.modes);
        let flow = measured((&family, self.beginning(case)), from, time)?;
        let (flow, place) = (flow.as_ref(), flow.place_in(from.0, from.1)?);
        Ok(match span {
            Span::Time(time) => until(flow, place, section, time)?,
            Span::Period(period) => once_around(flow, place, section, period)?,
        })
    }
}
