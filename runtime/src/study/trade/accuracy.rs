//! The cheapest setting that meets an accuracy.

use super::copy::Copies;
use super::lost::Lost;
use super::precision::at;
use super::record::{Need, Point, Setting};
use super::shoot::{self, Effort, Shooting};
use crate::field::Smoothing;
use crate::motion::Family;

/// Share of the accuracy that the smoothing alone may use.
const SHARE: f64 = 0.9;
/// Sizes tried on the way to the one that is needed.
const TRIES: usize = 8;
/// How near to that share the smoothing's error must come.
const NEAR: f64 = 0.98;

/// The loosest tolerance at which an orbit meets `accuracy` against `truth`.
pub(super) fn cheapest(
    family: &Family,
    tight: &Shooting,
    truth: &Shooting,
    accuracy: f64,
) -> Result<Setting, Lost> {
    let tolerances = (4..=22).map(|half| 0.1_f64.powf(0.5 * f64::from(half)));
    let met = tolerances
        .filter_map(|tolerance| at(family, tight, truth, tolerance).ok())
        .find(|point| point.total <= accuracy);
    met.map(|point| Setting {
        tolerance: point.tolerance,
        error: point.total,
        cost: point.cost,
    })
    .ok_or(Lost::NoTolerance { accuracy })
}

/// The size at which the measured errors, joined by straight lines in logarithms, fall to `error`.
fn size(points: &[Point], error: f64, of: impl Fn(&Point) -> f64) -> Option<f64> {
    let first = points.first()?;
    // The size itself: its logarithm's exponential is another number.
    if of(first) <= error || points.len() == 1 {
        return Some(first.size);
    }
    let logs: Vec<(f64, f64)> = points.iter().map(|p| (p.size.ln(), of(p).ln())).collect();
    let goal = error.ln();
    let pairs = || logs.windows(2).map(|pair| (pair[0], pair[1]));
    let (a, b) = pairs().find(|(_, b)| b.1 <= goal).or(pairs().next_back())?;
    let size = (a.0 + (b.0 - a.0) * (goal - a.1) / (b.1 - a.1)).exp();
    (size.is_finite() && size > 0.0).then_some(size)
}

fn largest(point: &Point) -> f64 {
    shoot::largest(point.frequency, &point.max_abs)
}

impl Copies<'_> {
    /// The size that a kernel needs for `accuracy`, verified, and the cheapest way to integrate it.
    pub(super) fn need(&self, kernel: usize, accuracy: f64) -> Result<Need, Lost> {
        let one = self.scope.kernels[kernel];
        let at = |size| Smoothing { kernel: one, size };
        let places = 0..self.scope.sizes(one).len();
        let mut found = places.filter_map(|place| self.copy(kernel, place).as_ref().ok());
        let mut points: Vec<Point> = found.clone().map(|(point, _)| point.clone()).collect();
        let finest = found.next_back();
        let mut finer = finest.map(|(point, shooting)| (at(point.size), shooting.clone()));
        let frequency_size = size(&points, accuracy, |p| p.frequency.abs()).ok_or(Lost::NoCopy)?;
        let goal = SHARE * accuracy;
        let mut best = None;
        for _ in 0..TRIES {
            let size = size(&points, goal * NEAR.sqrt(), largest).ok_or(Lost::NoCopy)?;
            let (point, shooting) = self.point(at(size), &|| finer.clone())?;
            let error = largest(&point);
            finer = Some((at(size), shooting.clone()));
            if error <= goal {
                best = Some((size, error, shooting));
                if error >= NEAR * NEAR * goal || size == points[0].size {
                    break;
                }
            }
            let towards = |p: &Point| at(p.size).sharpness();
            let place = points.partition_point(|p| towards(p) < towards(&point));
            points.insert(place, point);
        }
        let (size, error, shooting) = best.ok_or(Lost::NoSize { goal })?;
        let smoothing = at(size);
        let family = self.family(smoothing, Effort::TIGHT.tolerance);
        Ok(Need {
            smoothing,
            frequency_size,
            error,
            setting: cheapest(&family, &shooting, &self.truth, accuracy)?,
        })
    }
}
