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

use nalgebra::DMatrix;

use crate::flow::{self, FlowError};
use crate::linear::balanced;
use crate::motion::{Flow, Place};

/// Norm of a Jacobian over that in the units that make it least, above which its units are mixed.
const MIXED: f64 = 1e3;

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
    let jacobian = flow.velocity(place)?.jacobian;
    let (plain, least) = (size(&jacobian), size(&balanced(&jacobian)));
    // Any units bound it, and a shorter look first misses nothing; but a pressure in pascals would turn in no time.
    let norm = if plain > MIXED * least {
        match size(&balanced(&without_held(flow, place, jacobian)?)) {
            0.0 => plain,
            least => least,
        }
    } else {
        plain
    };
    Ok(if norm > 0.0 { 1.0 / norm } else { 1.0 }.min(longest(flow, place)?))
}

/// The Jacobian without what is left of it, rounding, in states that a contact holds by themselves.
fn without_held(
    flow: &dyn Flow,
    place: &Place,
    mut jacobian: DMatrix<f64>,
) -> Result<DMatrix<f64>, FlowError> {
    let contacts = flow.contacts(place)?.all;
    let held = contacts.iter().zip(&place.modes);
    for (contact, _) in held.filter(|(_, mode)| mode.binds()) {
        let slopes = contact.speed.slopes.iter().enumerate();
        let mut moved = slopes.filter(|(_, slope)| **slope != 0.0);
        if let (Some((state, _)), None) = (moved.next(), moved.next()) {
            jacobian.row_mut(state).fill(0.0);
        }
    }
    Ok(jacobian)
}

/// The largest sum over a row.
fn size(matrix: &DMatrix<f64>) -> f64 {
    let rows = matrix.row_iter();
    let sums = rows.map(|row| row.iter().map(|slope| slope.abs()).sum::<f64>());
    sums.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests;
