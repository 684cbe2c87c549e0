//! Lengths after which rates repeat along a course: the atoms under a tip, the sleepers under a wheel, the turn of a shaft.
//!
//! Of a wave only its slope is known at first: how far its rates swing over how steep they are is a share of its length. In
//! steps of a share of that, the least distance is looked for at which all rates are what they were, and sharpened by Newton's
//! method, r ← r − (f(r) − f(0))·f′/f′·f′.

use nalgebra::DVector;

use super::tried::velocity;
use crate::motion::Flow;

/// Places at which it is seen how far rates swing, within so many usual sizes.
const PLACES: usize = 16;
const WITHIN: f64 = 2.0;
/// A swing below this share of a rate is rounding.
const ROUNDING: f64 = 1e-9;
/// Share of the swing over the slope that is a step, and how many of them are made.
const STEP: f64 = 0.125;
const STEPS: usize = 2000;
/// Newton's steps, and how nearly rates then repeat, over how far they swing: what turns together is known nearly.
const NEWTON: usize = 8;
const SAME: f64 = 1e-4;
/// Golden section, of which no two multiples are as far from whole numbers as others.
const GOLDEN: f64 = 0.618_033_988_749_895;

/// The lengths, from the least on, after which the rates at a place repeat along this direction.
pub(super) fn wavelengths<'a>(
    flow: &'a dyn Flow,
    place: &'a [f64],
    direction: &'a [f64],
    usual: f64,
) -> impl Iterator<Item = f64> + 'a {
    let wave = Wave::of(flow, place, direction, usual);
    wave.into_iter().flat_map(Wave::lengths)
}

/// Rates along a direction, and their slopes.
struct Wave<'a> {
    flow: &'a dyn Flow,
    place: &'a [f64],
    direction: &'a [f64],
    begin: DVector<f64>,
    /// How far each rate swings.
    swing: DVector<f64>,
    step: f64,
}

impl<'a> Wave<'a> {
    /// `None` where rates do not change along it.
    fn of(flow: &'a dyn Flow, place: &'a [f64], direction: &'a [f64], usual: f64) -> Option<Self> {
        let (begin, slope) = rates(flow, place, direction, 0.0)?;
        let [mut low, mut high, mut steepest] = [begin.clone(), begin.clone(), slope.abs()];
        for k in 1..PLACES {
            let far = WITHIN * usual * (GOLDEN * k as f64).fract();
            let (f, slope) = rates(flow, place, direction, far)?;
            (low, high) = (low.inf(&f), high.sup(&f));
            steepest = steepest.sup(&slope.abs());
        }
        let heard = |most: f64, least: f64| {
            let swing = most - least;
            let size = most.abs().max(least.abs());
            if swing > ROUNDING * size { swing } else { 0.0 }
        };
        let swing = high.zip_map(&low, heard);
        let lengths = swing.iter().zip(&steepest);
        let lengths = lengths.filter(|(swing, slope)| **swing > 0.0 && **slope > 0.0);
        let shortest = lengths.map(|(swing, slope)| swing / slope);
        let shortest = shortest.min_by(f64::total_cmp)?;
        Some(Self {
            flow,
            place,
            direction,
            begin,
            swing,
            step: STEP * shortest,
        })
    }

    fn lengths(self) -> impl Iterator<Item = f64> + 'a {
        let mut before = [0.0, 0.0];
        (1..=STEPS).filter_map(move |k| {
            let off = self.off(self.step * k as f64)?.0.norm();
            let least = before[0] > before[1] && before[1] <= off;
            before = [before[1], off];
            let near = self.step * (k - 1) as f64;
            if least { self.sharper(near) } else { None }
        })
    }

    /// How far the rates are from what they were, over how far they swing, and the slopes of that.
    fn off(&self, far: f64) -> Option<(DVector<f64>, DVector<f64>)> {
        let (f, slope) = rates(self.flow, self.place, self.direction, far)?;
        let over = |rate: f64, swing: f64| if swing > 0.0 { rate / swing } else { 0.0 };
        let off = (f - &self.begin).zip_map(&self.swing, over);
        Some((off, slope.zip_map(&self.swing, over)))
    }

    /// The length near this one, if rates repeat there.
    fn sharper(&self, near: f64) -> Option<f64> {
        let mut length = near;
        for _ in 0..NEWTON {
            let (off, slope) = self.off(length)?;
            let square = slope.norm_squared();
            if square == 0.0 {
                break;
            }
            length -= off.dot(&slope) / square;
        }
        let same = self.off(length)?.0.amax() <= SAME;
        (same && length > self.step).then_some(length)
    }
}

/// Rates this far along a direction, and how they change along it.
fn rates(
    flow: &dyn Flow,
    place: &[f64],
    direction: &[f64],
    far: f64,
) -> Option<(DVector<f64>, DVector<f64>)> {
    let there: Vec<f64> = place
        .iter()
        .zip(direction)
        .map(|(y, d)| y + far * d)
        .collect();
    let velocity = velocity(flow, &there)?;
    let slopes = &velocity.jacobian * DVector::from_column_slice(direction);
    let finite = velocity
        .f
        .iter()
        .chain(&slopes)
        .all(|rate| rate.is_finite());
    finite.then_some((velocity.f, slopes))
}
