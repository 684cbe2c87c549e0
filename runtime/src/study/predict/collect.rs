//! From the responses at the section to errors of frequency and extrema (theory 7.2, step 5).

use super::PredictError;
use super::doubt::{cancelling, doubts};
use super::history::History;
use super::prediction::{Prediction, ReleaseLoss};
use super::rubbing::Rubbing;
use super::shift::Shift;
use crate::field::Smoothing;
use crate::shooting::Orbit;

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
        let shift = Shift::of(history, &readings, orbit)?;
        let peaks = peaks.iter().enumerate();
        let peak = |(j, time): (usize, &f64)| shift.peak(history, &readings, (j, *time), orbit);
        Ok(Self {
            frequency: -shift.period / history.period,
            max_abs: peaks.map(peak).collect(),
            start: shift.start,
        })
    }
}

/// The time at which each state has its largest magnitude: what runs on may have it where the lap ends.
fn peaks(history: &History, orbit: &Orbit) -> Vec<f64> {
    let peak = |j: usize| {
        let start = (orbit.place.state[j].abs(), 0.0);
        let extrema = history.passage.extrema.iter().filter(|e| e.index == j);
        let all = extrema.map(|e| (e.state[j].abs(), e.time));
        let end = (history.passage.end.state[j].abs(), history.period);
        let all = all.chain(orbit.runs(j).then_some(end));
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
