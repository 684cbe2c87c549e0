//! Harmonics of periodic motions: how far, and how late, each state swings at a multiple of the drive's frequency.

mod around;
mod series;

use nalgebra::Complex;

use crate::flow::FlowError;
use crate::integrate::Tolerance;
use crate::motion::Family;
pub use around::Around;
use around::{Motion, PANEL, ROUNDING, rate};
pub use series::series;

/// Tolerance of the motion over which harmonics are integrated, over that of the one with which it is compared.
const TIGHTER: f64 = 0.01;
/// What is reported over what two runs differ by: they share part of their errors.
const DOUBT: f64 = 1.5;

/// One harmonic of a periodic motion: each state holds the summand A cos(h φ + θ).
///
/// φ is the phase of the drive; without one, 2π t / T from the start of the orbit.
#[derive(Debug, Clone, PartialEq)]
pub struct Harmonic {
    /// h.
    pub order: usize,
    /// A of each state.
    pub amplitude: Vec<f64>,
    /// θ of each state, in radians, above −π up to π: negative for a state that lags behind cos(h φ).
    pub phase: Vec<f64>,
    /// Estimated error of the complex amplitude A exp(iθ) of each state, in the units of the state.
    pub error: Vec<f64>,
}

/// Harmonics of an orbit, and what finding them has told of it.
#[derive(Debug, Clone, Default)]
pub struct Harmonics {
    /// Those that were asked for, in their order.
    pub all: Vec<Harmonic>,
    /// How far the start of a driven orbit moves on the flow of the tighter tolerance, state by state: what its place has of
    /// error that shooting, which knows its own flow only, cannot see. Zeros without a drive.
    pub moved: Vec<f64>,
}

/// The harmonics of these orders of the orbit of `family` at r that begins at `place` and has this period; its
/// integration is held to `tolerance`, and to a tighter one for comparison. Of an orbit whose states gain `shift` once around
/// they are those of what does not run on.
///
/// # Errors
/// The motion cannot be followed.
pub fn harmonics(
    family: &Family,
    r: f64,
    around: Around<'_>,
    orders: &[usize],
    tolerance: Tolerance,
) -> Result<Harmonics, FlowError> {
    let at = |tolerance: Tolerance| family.with_tolerance(tolerance).at(r);
    let (rough, fine) = (at(tolerance)?, at(tolerance.times(TIGHTER))?);
    let highest = orders.iter().copied().max().unwrap_or(0) as f64;
    let panel = PANEL / ((1.0 + highest) * rate(fine.as_ref(), around)?);
    let rough = Motion::around(rough.as_ref(), around, 2.0 * panel)?;
    let fine = Motion::around(fine.as_ref(), around, panel)?;
    let harmonic = |&order: &usize| {
        let (other, found) = (rough.amplitudes(order), fine.amplitudes(order));
        let error = |(j, (a, b)): (usize, (&Complex<f64>, &Complex<f64>))| {
            DOUBT * (a - b).norm() + fine.gap[j].abs() + ROUNDING * fine.extent(j)
        };
        Harmonic {
            order,
            error: found.iter().zip(&other).enumerate().map(error).collect(),
            amplitude: found.iter().map(|c| c.norm()).collect(),
            phase: found.iter().map(|c| c.arg()).collect(),
        }
    };
    let ends = fine.start.iter().zip(&around.place.state);
    Ok(Harmonics {
        all: orders.iter().map(harmonic).collect(),
        moved: ends.map(|(fine, given)| (fine - given).abs()).collect(),
    })
}

#[cfg(test)]
mod tests;
