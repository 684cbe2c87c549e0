//! What tells a motion with several periods from a chaotic one: how fast its averages converge.

use super::ground::Ground;
use super::pursuit::{Pursuit, minima};
use super::record::{Attractor, Class};
use super::returns::{SETTLED, returns};
use crate::flow::FlowError;
use crate::lyapunov::lyapunov;
use crate::motion::Place;

/// Crossings that are left out, and crossings in each of two averages: more where few do not suffice.
const SETTLE: usize = 300;
const TAKEN: [usize; 2] = [600, 3000];
/// Passages that are followed at most.
const PASSAGES: usize = 30_000;
/// Two averages of a motion with several periods agree to this share of its extent, those of a chaotic one do not.
const REGULAR: f64 = 1e-6;
const IRREGULAR: f64 = 1e-4;
/// Standard errors by which an exponent differs from zero.
const SURE: f64 = 5.0;
/// Growth in one lap that is none.
const STILL: f64 = 3e-3;

/// The irregular motion on which a start settles; `None` if it is not irregular beyond doubt.
///
/// Averages with the weights exp(−1/(t(1−t))) converge faster than any power of their length where the motion has finitely
/// many periods, and like a square root where it is chaotic (Das, Saiki, Sander, Yorke 2017).
pub(super) fn irregular(
    ground: &Ground<'_>,
    start: &[f64],
) -> Result<Option<Attractor>, FlowError> {
    for taken in TAKEN {
        let Some(watched) = Watched::from(ground, start, taken)? else {
            return Ok(None);
        };
        if let Some(found) = watched.judged(ground, taken)? {
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
    let watched = Watched::from(ground, start, TAKEN[0])?;
    Ok(watched.map(|watched| watched.points))
}

struct Watched {
    points: Vec<Vec<f64>>,
    low: Vec<f64>,
    high: Vec<f64>,
    place: Place,
    lap: f64,
}

impl Watched {
    /// What it is beyond doubt; nothing irregular comes back on end.
    fn judged(self, ground: &Ground<'_>, taken: usize) -> Result<Option<Attractor>, FlowError> {
        if returns(self.points.iter().rev(), &ground.usual, SETTLED) {
            return Ok(None);
        }
        let (first, second) = self.points.split_at(taken);
        let (first, second) = (mean(first), mean(second));
        let mut found = Attractor::bare(Class::Torus, &second, None);
        found.min = self.low;
        found.max = self.high;
        let units = found.magnitude(&ground.usual);
        let phase = ground.flow.phase();
        let states = (0..units.len()).filter(|j| phase != Some(*j));
        let gaps = states.map(|j| (first[j] - second[j]).abs() / units[j]);
        let apart = gaps.fold(0.0, f64::max);
        let exponent = lyapunov(ground.flow.as_ref(), self.place, self.lap, taken)?;
        let Some(value) = exponent.exponent else {
            return Ok(None);
        };
        let still = value.abs() * self.lap <= STILL;
        found.exponent = Some([value, exponent.error]);
        found.class = match () {
            () if still && apart <= REGULAR => Class::Torus,
            () if !still && value > SURE * exponent.error && apart > IRREGULAR => Class::Chaos,
            () => return Ok(None),
        };
        Ok(Some(found))
    }

    fn from(ground: &Ground<'_>, start: &[f64], taken: usize) -> Result<Option<Self>, FlowError> {
        let flow = ground.flow.as_ref();
        let section = flow.phase().unwrap_or(0);
        let mut pursuit = Pursuit::new(flow, start)?;
        let (mut points, mut times) = (Vec::new(), Vec::new());
        let (mut low, mut high) = (
            vec![f64::INFINITY; start.len()],
            vec![f64::NEG_INFINITY; start.len()],
        );
        for _ in 0..PASSAGES {
            let begun = pursuit.time;
            let passage = pursuit.on()?;
            for minimum in minima(&passage, section) {
                times.push(begun + minimum.time);
                points.push(minimum.state.clone());
            }
            if points.len() <= SETTLE {
                continue;
            }
            for extremum in &passage.extrema {
                let (j, y) = (extremum.index, extremum.state[extremum.index]);
                low[j] = low[j].min(y);
                high[j] = high[j].max(y);
            }
            if points.len() >= SETTLE + 2 * taken {
                break;
            }
        }
        if points.len() < SETTLE + 2 * taken {
            return Ok(None);
        }
        for (j, y) in pursuit.place.state.iter().enumerate() {
            low[j] = low[j].min(*y);
            high[j] = high[j].max(*y);
        }
        if let Some(phase) = flow.phase() {
            (low[phase], high[phase]) = (0.0, std::f64::consts::TAU);
        }
        let last = SETTLE + 2 * taken - 1;
        Ok(Some(Self {
            lap: (times[last] - times[SETTLE]) / (last - SETTLE) as f64,
            points: points[SETTLE..=last].to_vec(),
            low,
            high,
            place: pursuit.place,
        }))
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
