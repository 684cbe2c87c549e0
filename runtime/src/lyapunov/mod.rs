//! The largest Lyapunov exponent of a motion, from a tangent that is carried along it.
//!
//! The tangent passes events through their saltation matrices, as all derivatives do (Müller 1995,
//! Chaos, Solitons & Fractals 5, 1671).

use borsh::{BorshDeserialize, BorshSerialize};

use crate::flow::{Flow, FlowError, Passage, Place, Want};

/// Growth in one lap, relative to the largest entry of Φ, that rounding errors decide.
const UNRESOLVED: f64 = 1e-13;
/// Share of the laps in which the tangent only turns to where it grows most.
const WARM_UP: f64 = 0.1;
/// Blocks that a standard error needs at least.
const BLOCKS: usize = 16;

/// A Lyapunov exponent.
#[derive(Debug, Clone, Copy, PartialEq, BorshSerialize, BorshDeserialize)]
#[cfg_attr(feature = "app", derive(serde::Serialize))]
pub struct Lyapunov {
    /// The exponent, in units of 1/time; `None` if a tangent vanishes within a lap: the motion is superstable.
    pub exponent: Option<f64>,
    /// Its standard error, the largest over blocks of all lengths: neighbouring laps are not independent.
    #[cfg_attr(feature = "app", serde(serialize_with = "crate::serial::finite"))]
    pub error: f64,
    /// The time over which it was averaged.
    pub time: f64,
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
pub fn lyapunov<F: Flow<N>, const N: usize>(
    flow: &F,
    mut place: Place<N, F::Mode>,
    lap: f64,
    laps: usize,
) -> Result<Lyapunov, FlowError> {
    let want = Want {
        derivatives: true,
        ..Want::default()
    };
    let mut tangent: [f64; N] = std::array::from_fn(|j| 1.0 / (1.0 + j as f64).sqrt());
    let warm_up = (WARM_UP * laps as f64).ceil() as usize;
    let mut rates = Vec::with_capacity(laps);
    for k in 0..laps + warm_up {
        let passage = flow.advance(&place, lap, want)?;
        let growth = match area::<F, N>(flow, &place, &passage)? {
            Some(growth) => Some(growth),
            None => carry::<F, N>(flow, &mut tangent, &passage)?,
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
fn area<F: Flow<N>, const N: usize>(
    flow: &F,
    from: &Place<N, F::Mode>,
    passage: &Passage<N, F::Mode>,
) -> Result<Option<f64>, FlowError> {
    let smooth = passage.events.iter().all(|event| !event.is_switch());
    let sticking = F::sticking(&from.mode) > 0;
    let Some(derivatives) = &passage.derivatives else {
        return Ok(None);
    };
    if N != 2 || !smooth || sticking || derivatives.lost > 0 {
        return Ok(None);
    }
    let before = norm(&flow.velocity(from)?.f);
    let along = (norm(&derivatives.time) / before).ln();
    let growth = derivatives.trace - along;
    Ok(growth.is_finite().then_some(growth))
}

/// Carries a tangent through one passage; ln of its growth, `None` if nothing is left of it.
fn carry<F: Flow<N>, const N: usize>(
    flow: &F,
    tangent: &mut [f64; N],
    passage: &Passage<N, F::Mode>,
) -> Result<Option<f64>, FlowError> {
    let Some(derivatives) = &passage.derivatives else {
        return Ok(None);
    };
    let stuck = passage.segments.iter().map(|s| F::sticking(&s.mode));
    if stuck.max().unwrap_or(0).max(derivatives.lost) + 1 >= N {
        return Ok(None);
    }
    let phi = &derivatives.state;
    let mut next: [f64; N] = std::array::from_fn(|i| dot(&phi[i], tangent));
    let velocity = flow.velocity(&passage.end)?.f;
    let share = dot(&next, &velocity) / dot(&velocity, &velocity);
    if share.is_finite() {
        next = std::array::from_fn(|j| next[j] - share * velocity[j]);
    }
    let growth = norm(&next);
    let largest = phi.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    if !growth.is_finite() || growth <= UNRESOLVED * largest {
        return Ok(None);
    }
    *tangent = next.map(|component| component / growth);
    Ok(Some(growth.ln()))
}

fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn norm<const N: usize>(a: &[f64; N]) -> f64 {
    dot(a, a).sqrt()
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
