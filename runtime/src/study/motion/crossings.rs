//! Points of a motion on a section.

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
        let flow = self.at(case)?;
        let place = flow.place(&self.start(case))?;
        Ok(match span {
            Span::Time(time) => until(flow.as_ref(), place, section, time)?,
            Span::Period(period) => once_around(flow.as_ref(), place, section, period)?,
        })
    }
}
