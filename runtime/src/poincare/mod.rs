//! Poincaré sections: surfaces that a motion crosses again and again, and the points where it does.
//!
//! Crossings are located on the motion itself, between extrema that the flow has located: no grid of
//! samples decides what is found.

mod crossing;
mod crossings;
mod horizon;
mod level;
mod meeting;
mod reach;
mod recurrence;
mod section;
mod span;
mod turns;

pub use crossing::Crossing;
pub use crossings::Crossings;
pub use horizon::{Horizon, Reason, Silence};
pub use recurrence::{approaches, recurrence};
pub use section::{Direction, Section, Surface};
pub use span::{Met, once_around, until};

use crate::flow::{self, FlowError};
use crate::linear::balanced;
use crate::motion::{Flow, Place};

/// The longest time for which a motion from `place` should be followed at once.
pub(crate) fn longest(flow: &dyn Flow, place: &Place) -> Result<f64, FlowError> {
    Ok(match flow.phase() {
        Some(phase) => flow::longest(flow.velocity(place)?.f[phase]),
        None => f64::INFINITY,
    })
}

/// A time in which the motion linearised at `place` turns by about a radian, and its drive not more often than can be
/// followed at once.
pub(crate) fn radian(flow: &dyn Flow, place: &Place) -> Result<f64, FlowError> {
    // In units that make it small: a pressure in pascals would turn in no time.
    let jacobian = balanced(&flow.velocity(place)?.jacobian);
    let rows = jacobian.row_iter();
    let norm = rows
        .map(|row| row.iter().map(|slope| slope.abs()).sum::<f64>())
        .fold(0.0, f64::max);
    Ok(if norm > 0.0 { 1.0 / norm } else { 1.0 }.min(longest(flow, place)?))
}

#[cfg(test)]
mod tests;
