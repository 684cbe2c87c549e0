//! The largest Lyapunov exponent of a motion, from a tangent that is carried along it.
//!
//! The tangent passes events through their saltation matrices, as all derivatives do (Müller 1995,
//! Chaos, Solitons & Fractals 5, 1671).

use nalgebra::DVector;
use serde::{Deserialize, Serialize};

use crate::flow::{FlowError, Want};
use crate::motion::{Flow, Passage, Place, sticking};

/// Growth in one lap, relative to the largest entry of Φ, that rounding errors decide.
const UNRESOLVED: f64 = 1e-13;
/// Share of the laps in which the tangent only turns to where it grows most.
const WARM_UP: f64 = 0.1;
/// Blocks that a standard error needs at least.
const BLOCKS: usize = 16;

/// A Lyapunov exponent.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Lyapunov {
    /// The exponent, in units of 1/time; `None` if a tangent vanishes within a lap: the motion is superstable.
    pub exponent: Option<f64>,
    /// Its standard error, the largest over blocks of all lengths: neighbouring laps are not independent.
    pub error: f64,
    /// The time over which it was averaged.
    pub time: f64,
}

/// Standard errors by which an exponent must be below 0 to be so.
const CERTAIN: f64 = 5.0;

impl Lyapunov {
    /// Whether motions beside it come to it, whatever its error is.
    #[must_use]
    pub fn attracts(&self) -> bool {
        let below = |exponent: f64| exponent + CERTAIN * self.error < 0.0;
        self.exponent.is_some_and(below)
    }
}

/// The largest exponent across the motion from `place` over `laps` laps of the time `lap`, after some to
/// warm up: the exponent 0 of the motion's own direction is left out, so that a periodic orbit has
/// ln |largest multiplier| / period.
///
/// It needs a motion: at rest the integrator takes steps of any length, and the eigenvalues of the
/// Jacobian say more.
///
/// # Errors
/// The motion cannot be followed, or has no derivative on the way.
pub fn lyapunov(
    flow: &dyn Flow,
    mut place: Place,
    lap: f64,
    laps: usize,
) -> Result<Lyapunov, FlowError> {
    let mut tangent = DVector::from_fn(flow.order(), |j, _| 1.0 / (1.0 + j as f64).sqrt());
    let warm_up = (WARM_UP * laps as f64).ceil() as usize;
    let mut rates = Vec::with_capacity(laps);
    for k in 0..laps + warm_up {
        let passage = flow.advance(&place, lap, Want::DERIVATIVES)?;
        let growth = match area(flow, &place, &passage)? {
            Some(growth) => Some(growth),
            None => carry(flow, &mut tangent, &passage)?,
        };
        let Some(growth) = growth else {
            return Ok(Lyapunov {
                exponent: None,
                error: 0.0,
                time: lap * (k + 1) as f64,
            });
        };
        if k >= warm_up {
            rates.push(growth / lap);
        }
        place = passage.end;
    }
    Ok(Lyapunov {
        exponent: Some(mean(&rates)),
        error: standard_error(&rates),
        time: lap * laps as f64,
    })
}

/// ln of the growth across a smooth motion in the plane, by Liouville: no rounding error hides it.
fn area(flow: &dyn Flow, from: &Place, passage: &Passage) -> Result<Option<f64>, FlowError> {
    let smooth = passage.events.iter().all(|event| !event.kind.is_switch());
    let sticks = sticking(&from.modes) > 0;
    let Some(derivatives) = &passage.derivatives else {
        return Ok(None);
    };
    if flow.order() != 2 || !smooth || sticks || derivatives.lost > 0 {
        return Ok(None);
    }
    let before = flow.velocity(from)?.f.norm();
    let along = (derivatives.time.norm() / before).ln();
    let growth = derivatives.determinant.log - along;
    Ok(growth.is_finite().then_some(growth))
}

/// Carries a tangent through one passage; ln of its growth, `None` if nothing is left of it.
fn carry(
    flow: &dyn Flow,
    tangent: &mut DVector<f64>,
    passage: &Passage,
) -> Result<Option<f64>, FlowError> {
    let Some(derivatives) = &passage.derivatives else {
        return Ok(None);
    };
    let stuck = passage.segments.iter().map(|s| sticking(&s.modes));
    if stuck.max().unwrap_or(0).max(derivatives.lost) + 1 >= flow.order() {
        return Ok(None);
    }
    let phi = &derivatives.state;
    let mut next = phi * &*tangent;
    let velocity = flow.velocity(&passage.end)?.f;
    let share = next.dot(&velocity) / velocity.norm_squared();
    if share.is_finite() {
        next -= share * velocity;
    }
    let growth = next.norm();
    let largest = phi.amax();
    if !growth.is_finite() || growth <= UNRESOLVED * largest {
        return Ok(None);
    }
    *tangent = next / growth;
    Ok(Some(growth.ln()))
}

fn mean(series: &[f64]) -> f64 {
    series.iter().sum::<f64>() / series.len().max(1) as f64
}

/// The standard error of the mean of a correlated series: the largest over blocks of 1, 2, 4, ... values
/// (Flyvbjerg & Petersen 1989). Infinite for a single value.
fn standard_error(series: &[f64]) -> f64 {
    let mut blocks = series.to_vec();
    let mut largest = independent(&blocks);
    while blocks.len() >= 2 * BLOCKS {
        blocks = blocks.chunks_exact(2).map(mean).collect();
        largest = largest.max(independent(&blocks));
    }
    largest
}

fn independent(series: &[f64]) -> f64 {
    let (count, mean) = (series.len() as f64, mean(series));
    if series.len() < 2 {
        return f64::INFINITY;
    }
    let squares: f64 = series.iter().map(|x| (x - mean).powi(2)).sum();
    (squares / (count - 1.0) / count).sqrt()
}

#[cfg(test)]
mod tests;
