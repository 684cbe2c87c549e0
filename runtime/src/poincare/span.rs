//! The crossings of a motion within a time, or once around an orbit.

use super::crossings::{Crossing, Crossings};
use super::section::Section;
use crate::flow::FlowError;
use crate::motion::{Flow, Place};

/// Share of a period by which a start may be off the section that it lies on.
const INSTANT: f64 = 1e-6;

/// The crossings of the motion from `place` up to the time `time`.
///
/// # Errors
/// The motion cannot be followed.
pub fn until(
    flow: &dyn Flow,
    place: Place,
    section: Section,
    time: f64,
) -> Result<Vec<Crossing>, FlowError> {
    let mut crossings = Crossings::new(flow, place, section)?;
    let mut found = Vec::new();
    for crossing in &mut crossings {
        match crossing? {
            crossing if crossing.time <= time => found.push(crossing),
            _ => break,
        }
    }
    Ok(found)
}

/// The crossings of the periodic orbit through `place` in one period, each once; their number is the
/// n of a period-n motion.
///
/// # Errors
/// The motion cannot be followed.
pub fn once_around(
    flow: &dyn Flow,
    place: Place,
    section: Section,
    period: f64,
) -> Result<Vec<Crossing>, FlowError> {
    let near = INSTANT * period;
    let mut found = until(flow, place, section, period + near)?;
    // A start on the section is met at the end, not at the beginning.
    found.retain(|crossing| crossing.time > near);
    Ok(found)
}
