//! The section of a diagram for which none is asked.

use crate::flow::{FlowError, Want};
use crate::poincare::{Section, radian};
use crate::shooting::turning;
use crate::study::error::StudyError;
use crate::study::question::Case;
use crate::study::system::System;

/// Looks at a motion, each twice as long as the one before, and minima of the first state in one that make it the section's.
const LOOKS: u32 = 14;
const TURNS: usize = 2;

impl System {
    /// Where the points of a diagram are taken if nothing is said: where the phase of the drive begins anew, or the first
    /// state is least; where that only runs on, as the angle of a shaft, another one that turns.
    ///
    /// # Errors
    /// The case cannot be asked.
    pub fn section(&self, case: &Case) -> Result<Section, StudyError> {
        self.check(case)?;
        let usual = Section::usual(self.info().drive);
        if self.info().drive.is_some() {
            return Ok(usual);
        }
        // Why a motion cannot be followed is told where it is asked for.
        let other = self.instead(case).unwrap_or(None);
        Ok(other.map_or(usual, Section::least))
    }

    /// The state that turns where the first one only runs on, if it does.
    fn instead(&self, case: &Case) -> Result<Option<usize>, FlowError> {
        let flow = self.at(case)?;
        let mut place = flow.place(&self.start(case))?;
        let mut time = radian(flow.as_ref(), &place)?;
        for _ in 0..LOOKS {
            let passage = flow.advance(&place, time, Want::EXTREMA)?;
            if passage.lows(0).count() >= TURNS {
                return Ok(None);
            }
            if let Some((other, shifts)) = turning(flow.as_ref(), &passage, time) {
                return Ok(shifts.may_run(0).then_some(other));
            }
            (place, time) = (passage.end, 2.0 * time);
        }
        Ok(None)
    }
}
