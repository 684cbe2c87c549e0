//! The orbit a little further along its branch: how all that is read off an orbit changes there.

use super::orbit::Orbit;
use super::shot::Shot;
use crate::field::Work;
use crate::flow::{FlowError, Want};
use crate::motion::{Family, Place};

/// How far, in scaled coordinates: so little that the tangent alone matters, so much that errors of motions do not.
const STEP: f64 = 1e-5;

/// What is read off the orbit a little further along its branch, to first order.
#[derive(Debug, Clone, PartialEq)]
pub struct Beside {
    /// The design variable.
    pub r: f64,
    /// Where shooting starts.
    pub start: Place,
    /// The period.
    pub period: f64,
    /// Largest value of each state.
    pub max: Vec<f64>,
    /// Smallest value of each state.
    pub min: Vec<f64>,
    /// Its points on the default section, in the order of those of the orbit.
    pub section: Vec<Vec<f64>>,
    /// What it cost.
    pub work: Work,
}

impl Orbit {
    /// The orbit a little further along its branch: on its tangent, which is exact. Nothing where that is not known: off any
    /// branch, where shooting has several segments, where it runs on, and where other things happen on the way around.
    #[must_use]
    pub fn beside(&self, family: &Family) -> Option<Beside> {
        let family = family.with_magnitude(&self.magnitude());
        // Beyond the end of a range, a parameter may be out of its bounds.
        let ways = [STEP, -STEP].into_iter();
        let mut moved = ways.filter_map(|step| self.moved(&family, step).ok()?);
        moved.find(|beside| beside.section.len() == self.section.len())
    }

    fn moved(&self, family: &Family, step: f64) -> Result<Option<Beside>, FlowError> {
        let (Some(way), None) = (&self.heading.way, &self.shift) else {
            return Ok(None);
        };
        let (mut start, order) = (self.heading.start.clone(), self.max.len());
        for (value, rate) in start.state.iter_mut().zip(way.iter()) {
            *value += step * rate;
        }
        let period = self.period + step * way[order];
        let r = self.r + step * way[order + 1];
        let flow = family.at(r)?;
        let passage = flow.advance(&start, period, Want::EXTREMA)?;
        let (work, segments) = (passage.work, &passage.segments);
        let modes = segments.iter().map(|segment| &segment.modes);
        if !modes.eq(self.segments.iter().map(|segment| &segment.modes)) {
            return Ok(None);
        }
        let shot = Shot {
            velocity: flow.velocity(&start)?,
            passages: vec![passage],
            start: start.clone(),
            period,
            begins: vec![0.0],
            drive: flow.phase(),
            closure: 0.0,
            pins: Vec::new(),
            shift: None,
        };
        let (min, max) = shot.extent();
        let section = shot.minima().map(|(_, state)| state).collect();
        Ok(Some(Beside {
            r,
            start,
            period,
            max,
            min,
            section,
            work,
        }))
    }
}
