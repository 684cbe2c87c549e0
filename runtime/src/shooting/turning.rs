//! Which state makes the section of a motion whose first only runs on: one that turns often.

use super::shift::Shifts;
use crate::motion::{Extremum, Flow, Passage};

/// Turns of a state after which it is the section's.
const OFTEN: usize = 8;
/// Share of a passage within which two times are the same instant.
const INSTANT: f64 = 1e-9;

/// The first state that turns often in a passage of this length, and the shifts that change nothing in its sizes.
pub(crate) fn turning(flow: &dyn Flow, passage: &Passage, time: f64) -> Option<(usize, Shifts)> {
    // Where contacts switch, a motion that begins there may be in another mode.
    let switches = |one: &Extremum| {
        let mut events = passage.events.iter();
        events.any(|event| event.switches() && (event.time - one.time).abs() <= INSTANT * time)
    };
    let often = |j: &usize| {
        let minima = passage.lows(*j);
        minima.filter(|one| !switches(one)).count() >= OFTEN
    };
    let calm = &passage.calm;
    let state = (0..calm.low.len()).find(often)?;
    let extents = calm.high.iter().zip(&calm.low);
    let sizes: Vec<f64> = extents.map(|(high, low)| half(high - low)).collect();
    Some((state, Shifts::of(flow, &sizes)))
}

/// Half of an extent; 1 where there is none.
pub(super) fn half(extent: f64) -> f64 {
    if extent > 0.0 { 0.5 * extent } else { 1.0 }
}
