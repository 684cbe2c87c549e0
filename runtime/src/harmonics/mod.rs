//! Harmonics of periodic motions: how far, and how late, each state swings at a multiple of the drive's frequency.

use std::f64::consts::TAU;

use nalgebra::{Complex, DMatrix, DVector};

use crate::flow::{FlowError, Want};
use crate::integrate::Tolerance;
use crate::linear::svd;
use crate::motion::{Family, Flow, Node, Place};

/// Angle of the highest harmonic, and of the motion itself, over a panel of six nodes: their error is far below rounding.
const PANEL: f64 = 1.0;
/// Tolerance of the motion over which harmonics are integrated, over that of the one with which it is compared.
const TIGHTER: f64 = 0.01;
/// What is reported over what two runs differ by: they share part of their errors.
const DOUBT: f64 = 1.5;
/// Directions in which a disturbance lasts for longer than this many turns say nothing of where an orbit begins.
const LASTING: f64 = 1e7;
/// Rounding error of an integral, relative to the extent of a state.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

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
) -> Result<Vec<Harmonic>, FlowError> {
    let at = |tolerance: Tolerance| family.with_tolerance(tolerance).at(r);
    let (rough, fine) = (at(tolerance)?, at(tolerance.times(TIGHTER))?);
    let highest = orders.iter().copied().max().unwrap_or(0) as f64;
    let rate = match fine.phase() {
        Some(phase) => fine.velocity(around.place)?.f[phase],
        None => TAU / around.period,
    };
    let panel = PANEL / ((1.0 + highest) * rate);
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
    Ok(orders.iter().map(harmonic).collect())
}

/// An orbit whose harmonics are meant.
#[derive(Debug, Clone, Copy)]
pub struct Around<'a> {
    /// Where it begins.
    pub place: &'a Place,
    /// Its period.
    pub period: f64,
    /// What the states gain once around, where it runs on; else nothing.
    pub shift: &'a [f64],
}

/// A periodic motion at the nodes of a quadrature.
struct Motion {
    period: f64,
    phase: Option<usize>,
    start: Vec<f64>,
    nodes: Vec<Node>,
    /// By how much each state misses its start when it comes back.
    gap: DVector<f64>,
}

impl Motion {
    /// Once around the orbit of this flow near `place`: under a drive, whose period is certain, from one correction of
    /// that place, if it brings the motion closer to where it began.
    fn around(flow: &dyn Flow, around: Around<'_>, panel: f64) -> Result<Self, FlowError> {
        let given = Self::follow(flow, around, panel)?;
        if flow.phase().is_none() {
            return Ok(given);
        }
        let corrected = corrected(flow, around.place, around.period, &given.gap)?;
        let corrected = corrected.map(|place| {
            let place = &place;
            Self::follow(flow, Around { place, ..around }, panel)
        });
        Ok(match corrected {
            Some(Ok(other)) if other.gap.norm() < given.gap.norm() => other,
            _ => given,
        })
    }

    fn follow(flow: &dyn Flow, around: Around<'_>, panel: f64) -> Result<Self, FlowError> {
        let Around {
            place,
            period,
            shift,
        } = around;
        let want = Want {
            panel,
            ..Want::default()
        };
        let mut passage = flow.advance(place, period, want)?;
        for (j, gain) in shift.iter().enumerate() {
            passage.end.state[j] -= gain;
            for node in &mut passage.nodes {
                node.state[j] -= gain * node.time / period;
            }
        }
        let mut gap =
            DVector::from_vec(passage.end.state) - DVector::from_column_slice(&place.state);
        if let Some(phase) = flow.phase() {
            gap[phase] = 0.0;
        }
        Ok(Self {
            period,
            phase: flow.phase(),
            start: place.state.clone(),
            nodes: passage.nodes,
            gap,
        })
    }

    /// The complex amplitude A exp(iθ) of each state at this harmonic.
    ///
    /// What a state is at the start has no harmonics, and is left out before it cancels.
    fn amplitudes(&self, order: usize) -> Vec<Complex<f64>> {
        let mut sums = vec![Complex::new(0.0, 0.0); self.start.len()];
        for node in &self.nodes {
            let angle = match self.phase {
                Some(phase) => node.state[phase],
                None => TAU * node.time / self.period,
            };
            let turned =
                Complex::from_polar(2.0 * node.weight / self.period, -angle * order as f64);
            for (j, sum) in sums.iter_mut().enumerate() {
                *sum += turned * (node.state[j] - self.start[j]);
            }
        }
        if let Some(phase) = self.phase {
            sums[phase] = Complex::new(0.0, 0.0);
        }
        sums
    }

    /// How far a state goes from its start.
    fn extent(&self, j: usize) -> f64 {
        let values = self.nodes.iter().map(|node| node.state[j] - self.start[j]);
        values.fold(0.0, |most, value| most.max(value.abs()))
    }
}

/// The place from which, to first order, the motion comes back; `None` where that is not known.
fn corrected(
    flow: &dyn Flow,
    place: &Place,
    period: f64,
    gap: &DVector<f64>,
) -> Result<Option<Place>, FlowError> {
    let passage = flow.advance(place, period, Want::DERIVATIVES)?;
    let Some(derivatives) = passage.derivatives else {
        return Ok(None);
    };
    let order = gap.len();
    let mut stays = DMatrix::identity(order, order) - derivatives.state;
    // The phase of a drive comes back by itself.
    if let Some(phase) = flow.phase() {
        stays.column_mut(phase).fill(0.0);
    }
    let step = svd(stays).and_then(|svd| svd.solve(gap, svd.singular_values.max() / LASTING).ok());
    let step = step.filter(|step| step.iter().all(|change| change.is_finite()));
    Ok(step.map(|step| Place {
        state: place
            .state
            .iter()
            .zip(&step)
            .map(|(x, change)| x + change)
            .collect(),
        modes: place.modes.clone(),
    }))
}

#[cfg(test)]
mod tests;
