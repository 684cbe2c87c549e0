//! From the responses at the section to errors of frequency and extrema (theory 7.2, step 5).

use nalgebra::{DMatrix, DVector};

use super::PredictError;
use super::doubt::{cancelling, doubts};
use super::history::History;
use super::prediction::{Prediction, ReleaseLoss};
use super::response::Response;
use super::rubbing::Rubbing;
use crate::field::Smoothing;
use crate::shooting::Orbit;

/// Rate of a state at its extremum, in units of its magnitude per period, above which it has a corner there.
const CORNER: f64 = 1e-4;

/// Predicts the errors of the copy of a model with this smoothing from its exact orbit.
///
/// # Errors
/// See [`PredictError`].
pub(in super::super) fn predict(
    model: &dyn Rubbing,
    orbit: &Orbit,
    smoothing: Smoothing,
) -> Result<Prediction, PredictError> {
    let mut history = History::of(model, orbit, smoothing)?;
    if history.switches.iter().all(|s| s.release.is_none()) {
        return Err(PredictError::NeverSticks);
    }
    let peaks = peaks(&history, orbit);
    let times = times(&history, &peaks);
    let leading = match history.lose(model, true) {
        Ok(()) => Some(Errors::of(model, &history, (&peaks, &times), orbit)?),
        Err(_) => None,
    };
    history.lose(model, false)?;
    let refined = Errors::of(model, &history, (&peaks, &times), orbit)?;
    let cancelling = match &leading {
        Some(leading) => cancelling(smoothing.kernel, &leading.max_abs, &refined.max_abs),
        None => vec![false; peaks.len()],
    };
    let mut prediction = Prediction {
        smoothing,
        frequency: refined.frequency,
        leading: leading.map(|leading| leading.frequency),
        max_abs: refined.max_abs,
        cancelling,
        start: refined.start,
        releases: releases(&history),
        doubts: Vec::new(),
    };
    prediction.doubts = doubts(&history, &prediction);
    Ok(prediction)
}

/// What the losses of a history make of frequency, extrema and start.
struct Errors {
    frequency: f64,
    max_abs: Vec<Option<f64>>,
    start: Vec<f64>,
}

impl Errors {
    fn of(
        model: &dyn Rubbing,
        history: &History,
        (peaks, times): (&[f64], &[f64]),
        orbit: &Orbit,
    ) -> Result<Self, PredictError> {
        let readings = model.response(history, times)?;
        let shift = Shift::of(history, &readings)?;
        let peaks = peaks.iter().enumerate();
        let peak = |(j, time): (usize, &f64)| shift.peak(history, &readings, j, *time, orbit);
        Ok(Self {
            frequency: -shift.period / history.period,
            max_abs: peaks.map(peak).collect(),
            start: shift.start,
        })
    }
}

/// The time at which each state has its largest magnitude.
fn peaks(history: &History, orbit: &Orbit) -> Vec<f64> {
    let peak = |j: usize| {
        let start = (orbit.place.state[j].abs(), 0.0);
        let extrema = history.passage.extrema.iter().filter(|e| e.index == j);
        let all = extrema.map(|e| (e.state[j].abs(), e.time));
        all.fold(start, |a, b| if b.0 > a.0 { b } else { a }).1
    };
    (0..orbit.place.state.len()).map(peak).collect()
}

fn times(history: &History, peaks: &[f64]) -> Vec<f64> {
    let mut times = peaks.to_vec();
    times.push(history.period);
    times.retain(|&t| t > 0.0);
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

/// How far the copy's orbit lies from the exact one.
struct Shift {
    start: Vec<f64>,
    period: f64,
}

impl Shift {
    /// The fixed point moves by (I − DP)⁻¹ q_P; bordered by the field, which gives the period as well.
    fn of(history: &History, readings: &[Response]) -> Result<Self, PredictError> {
        let last = readings.last().ok_or(PredictError::Singular)?;
        let (f, n) = (&last.velocity, last.velocity.len());
        let matrix = DMatrix::from_fn(n + 1, n + 1, |i, j| match (i == n, j == n) {
            (true, true) => 0.0,
            (true, false) => f[j],
            (false, true) => f[i] * history.period,
            (false, false) => last.tangent[i][j] - f64::from(i == j),
        });
        let mut right = DVector::zeros(n + 1);
        for (i, value) in last.deviation.iter().enumerate() {
            right[i] = -value;
        }
        let solution = matrix.lu().solve(&right).ok_or(PredictError::Singular)?;
        Ok(Self {
            start: solution.rows(0, n).iter().copied().collect(),
            period: solution[n] * history.period,
        })
    }

    /// Relative error of the largest magnitude of state j, reached at `time`.
    fn peak(
        &self,
        history: &History,
        readings: &[Response],
        j: usize,
        time: f64,
        orbit: &Orbit,
    ) -> Option<f64> {
        let at = readings
            .iter()
            .find(|r| r.time == time || time == 0.0 && r.time == history.period)?;
        let corner =
            (at.velocity[j] * history.period).abs() > CORNER * (orbit.max[j] - orbit.min[j]);
        let near = |t: f64| (t - time).abs() < 1e-9 * history.period;
        if corner || history.switches.iter().any(|s| near(s.event.time)) {
            return None;
        }
        let moved = if time == 0.0 {
            self.start[j]
        } else {
            let row = at.tangent[j].iter().zip(&self.start);
            row.map(|(t, d)| t * d).sum::<f64>() + at.deviation[j]
        };
        Some(moved / at.state[j])
    }
}

fn releases(history: &History) -> Vec<ReleaseLoss> {
    let found = history.switches.iter().filter_map(|switch| {
        let (release, loss) = switch.release.zip(switch.loss)?;
        Some(ReleaseLoss {
            contact: release.local.contact,
            time: release.time,
            acceleration: release.local.acceleration,
            compliance: release.local.compliance,
            offset: loss.offset,
            delay: loss.delay,
            layer: loss.layer,
            room: release.stuck.min(release.slides),
        })
    });
    found.collect()
}
