//! What tells a motion with several periods from a chaotic one: how fast its averages converge.

use super::ground::Ground;
use super::pursuit::Pursuit;
use super::record::{Attractor, Class};
use super::returns::{SETTLED, returns};
use crate::flow::FlowError;
use crate::lyapunov::lyapunov;

/// Crossings that are left out, and crossings in each of two averages: more where few do not suffice.
const SETTLE: usize = 300;
const TAKEN: [usize; 3] = [200, 600, 3000];
/// Crossings that tell which places are visited.
const VISITED: usize = 1200;
/// Passages that are followed at most.
const PASSAGES: usize = 30_000;
/// Two averages of a motion with several periods agree to this share of its extent, those of a chaotic one do not.
const REGULAR: f64 = 1e-6;
const IRREGULAR: f64 = 1e-4;
/// Standard errors by which an exponent differs from zero.
const SURE: f64 = 5.0;
/// Growth in one lap that may be none, and one that is none beside rounding errors.
const STILL: f64 = 3e-3;
const NOTHING: f64 = 1e-6;

/// The irregular motion on which a start settles; `None` if it is not irregular beyond doubt.
///
/// Averages with the weights exp(−1/(t(1−t))) converge faster than any power of their length where the motion has finitely
/// many periods, and like a square root where it is chaotic (Das, Saiki, Sander, Yorke 2017).
pub(super) fn irregular(
    ground: &Ground<'_>,
    start: &[f64],
) -> Result<Option<Attractor>, FlowError> {
    let mut watched = Watched::new(ground, start)?;
    for taken in TAKEN {
        // Nothing irregular comes back on end.
        if !watched.until(2 * taken)? || watched.returns() {
            return Ok(None);
        }
        if let Some(found) = watched.judged(taken)? {
            return Ok(Some(found));
        }
    }
    Ok(None)
}

/// The points at which the motion from a start meets its section once it has settled; `None` if it does so too seldom.
pub(super) fn visited(
    ground: &Ground<'_>,
    start: &[f64],
) -> Result<Option<Vec<Vec<f64>>>, FlowError> {
    let mut watched = Watched::new(ground, start)?;
    let enough = watched.until(VISITED)?;
    Ok(enough.then_some(watched.points))
}

/// A motion that has settled, followed from crossing to crossing of its section.
struct Watched<'g> {
    ground: &'g Ground<'g>,
    pursuit: Pursuit<'g>,
    passages: usize,
    times: Vec<f64>,
    points: Vec<Vec<f64>>,
    low: Vec<f64>,
    high: Vec<f64>,
}

impl<'g> Watched<'g> {
    /// From a start, once it has settled if it ever does.
    fn new(ground: &'g Ground<'g>, start: &[f64]) -> Result<Self, FlowError> {
        let mut watched = Self {
            ground,
            pursuit: Pursuit::new(ground.flow.as_ref(), start)?,
            passages: 0,
            times: Vec::new(),
            points: Vec::new(),
            low: vec![f64::INFINITY; start.len()],
            high: vec![f64::NEG_INFINITY; start.len()],
        };
        watched.until(SETTLE)?;
        watched.times.clear();
        watched.points.clear();
        watched.low.fill(f64::INFINITY);
        watched.high.fill(f64::NEG_INFINITY);
        Ok(watched)
    }

    /// Follows it until it has crossed its section so often; whether it did.
    fn until(&mut self, count: usize) -> Result<bool, FlowError> {
        let section = self.ground.flow.phase().unwrap_or(0);
        while self.points.len() < count && self.passages < PASSAGES {
            let begun = self.pursuit.time;
            let passage = self.pursuit.on()?;
            self.passages += 1;
            for minimum in passage.minima(section) {
                self.times.push(begun + minimum.time);
                self.points.push(minimum.state.clone());
            }
            for extremum in &passage.extrema {
                let (j, y) = (extremum.index, extremum.state[extremum.index]);
                self.low[j] = self.low[j].min(y);
                self.high[j] = self.high[j].max(y);
            }
        }
        Ok(self.points.len() >= count)
    }

    fn returns(&self) -> bool {
        returns(self.points.iter().rev(), &self.ground.usual, SETTLED).is_some()
    }

    /// What it is beyond doubt, by averages of so many crossings each.
    fn judged(&self, taken: usize) -> Result<Option<Attractor>, FlowError> {
        let ground = self.ground;
        let [first, second] = [0, taken].map(|from| mean(&self.points[from..from + taken]));
        let mut found = Attractor::bare(Class::Torus, &second, None);
        (found.min, found.max) = self.extent();
        let units = found.magnitude(&ground.usual);
        let phase = ground.flow.phase();
        let states = (0..units.len()).filter(|j| phase != Some(*j));
        let gaps = states.map(|j| (first[j] - second[j]).abs() / units[j]);
        let apart = gaps.fold(0.0, f64::max);
        let lap = (self.times[2 * taken - 1] - self.times[0]) / (2 * taken - 1) as f64;
        let place = self.pursuit.place.clone();
        let exponent = lyapunov(ground.flow.as_ref(), place, lap, taken)?;
        let Some(value) = exponent.exponent else {
            return Ok(None);
        };
        let growth = value.abs() * lap;
        let sure = value.abs() > SURE * exponent.error && growth > NOTHING;
        found.exponent = Some([value, exponent.error]);
        found.class = match () {
            () if !sure && growth <= STILL && apart <= REGULAR => Class::Torus,
            () if sure && growth > STILL && value > 0.0 && apart > IRREGULAR => Class::Chaos,
            // A small one that is sure is that of a motion that settles slowly.
            () => return Ok(None),
        };
        Ok(Some(found))
    }

    /// What the states extend over.
    fn extent(&self) -> (Vec<f64>, Vec<f64>) {
        let end = &self.pursuit.place.state;
        let bound = |far: fn(f64, f64) -> f64, turns: &[f64]| -> Vec<f64> {
            turns.iter().zip(end).map(|(a, b)| far(*a, *b)).collect()
        };
        let (mut low, mut high) = (bound(f64::min, &self.low), bound(f64::max, &self.high));
        if let Some(phase) = self.ground.flow.phase() {
            (low[phase], high[phase]) = (0.0, std::f64::consts::TAU);
        }
        (low, high)
    }
}

/// The weighted average of points.
fn mean(points: &[Vec<f64>]) -> Vec<f64> {
    let count = points.len() as f64;
    let weight = |k: usize| {
        let t = (k as f64 + 0.5) / count;
        (-1.0 / (t * (1.0 - t))).exp()
    };
    let sum: f64 = (0..points.len()).map(weight).sum();
    let order = points.first().map_or(0, Vec::len);
    let mean = |j: usize| {
        let terms = points
            .iter()
            .enumerate()
            .map(|(k, point)| weight(k) * point[j]);
        terms.sum::<f64>() / sum
    };
    (0..order).map(mean).collect()
}
