//! How long a crossing is awaited, and why no longer.

use serde::{Deserialize, Serialize};

use super::reach::Reach;
use crate::flow::FlowError;
use crate::motion::{Flow, Passage, Place};

/// Steps of the integrator without a crossing after which no more are awaited.
const STEPS: u64 = 500_000;
/// Passages without a crossing after which no more are awaited: each is twice as long as the one before unless it takes
/// many steps, so that all together are longer than any motion.
const PASSAGES: u32 = 200;
/// Turns that a passage needs so that its extent tells something.
const TURNS: usize = 16;
/// Laps of the drive that it needs besides.
const LAPS: usize = 2;
/// Extents that agree to this share of themselves are the same.
const SAME: f64 = 1e-5;
/// A motion whose extent is this share of what it has been before, or usually is, is at rest.
const REST: f64 = 1e-6;
/// A rate this small, in units of its terms, is rounding error.
const NOISE: f64 = 16.0 * f64::EPSILON;
/// Passages on end that must agree, or rest.
const ON_END: u32 = 4;

/// How long a motion is watched for crossings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Horizon {
    /// For this time.
    Time(f64),
    /// As long as a crossing may come: until the motion rests, goes on within the same bounds, or has taken half a
    /// million steps since it last crossed.
    Recurrence,
}

/// Why no more crossings are awaited.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Reason {
    /// The motion rests.
    Rest,
    /// It goes on within bounds that change no more.
    Bounded,
    /// It has been followed for very long.
    Long,
}

/// A stretch of a motion, up to now, on which it has crossed nothing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Silence {
    /// Why it is followed no longer.
    pub reason: Reason,
    /// How long it is.
    pub time: f64,
    /// Steps of the integrator in it.
    pub steps: u64,
    /// Smallest value of each state.
    pub low: Vec<f64>,
    /// Largest value of each state.
    pub high: Vec<f64>,
}

/// Watches a motion since it last crossed.
pub(super) struct Patience {
    pub(super) time: f64,
    steps: u64,
    passages: u32,
    reach: Reach,
    last: Option<Reach>,
    bounded: u32,
    resting: u32,
}

impl Patience {
    pub(super) fn from(place: &Place) -> Self {
        Self {
            time: 0.0,
            steps: 0,
            passages: 0,
            reach: Reach::at(&place.state),
            last: None,
            bounded: 0,
            resting: 0,
        }
    }

    /// Told of a passage without a crossing that took `time` and reached from bound to bound; `sizes` are those of
    /// the states.
    pub(super) fn take(
        &mut self,
        flow: &dyn Flow,
        passage: &Passage,
        (time, reach): (f64, Reach),
        sizes: &[f64],
    ) -> Result<(), FlowError> {
        self.time += time;
        self.steps += passage.work.steps + passage.work.rejected;
        self.passages += 1;
        self.reach.join(&reach);
        let bounded = turns(flow, passage) && self.last.as_ref().is_some_and(|l| same(l, &reach));
        self.bounded = if bounded { self.bounded + 1 } else { 0 };
        let resting = rests(flow, &passage.end, time, (&reach, sizes))?;
        self.resting = if resting { self.resting + 1 } else { 0 };
        self.last = Some(reach);
        Ok(())
    }

    /// Why no more is awaited, if that is so.
    pub(super) fn end(&self) -> Option<Reason> {
        if self.resting >= ON_END {
            Some(Reason::Rest)
        } else if self.bounded >= ON_END {
            Some(Reason::Bounded)
        } else {
            (self.steps >= STEPS || self.passages >= PASSAGES).then_some(Reason::Long)
        }
    }

    /// What it has seen.
    pub(super) fn silence(&self) -> Option<Silence> {
        Some(Silence {
            reason: self.end()?,
            time: self.time,
            steps: self.steps,
            low: self.reach.low.clone(),
            high: self.reach.high.clone(),
        })
    }
}

/// Whether a passage has gone to and fro often enough.
fn turns(flow: &dyn Flow, passage: &Passage) -> bool {
    let laps = passage
        .extrema
        .iter()
        .filter(|e| Some(e.index) == flow.phase());
    let laps_enough = flow.phase().is_none() || laps.count() >= LAPS;
    laps_enough && passage.extrema.len() >= TURNS
}

/// Whether two passages have the same bounds.
fn same(a: &Reach, b: &Reach) -> bool {
    (0..a.low.len()).all(|j| {
        let apart = (a.low[j] - b.low[j])
            .abs()
            .max((a.high[j] - b.high[j]).abs());
        apart <= SAME * a.extent(j).max(b.extent(j))
    })
}

/// Whether nothing moved in a passage, and nothing would in one more, measured against the sizes of the states.
fn rests(
    flow: &dyn Flow,
    end: &Place,
    time: f64,
    (reach, sizes): (&Reach, &[f64]),
) -> Result<bool, FlowError> {
    let small = |j: usize, change: f64| change <= REST * sizes[j];
    if flow.phase().is_some() || !(0..reach.low.len()).all(|j| small(j, reach.extent(j))) {
        return Ok(false);
    }
    let velocity = flow.velocity(end)?;
    let still = |j: usize| {
        let term = |(k, state): (usize, &f64)| (velocity.jacobian[(j, k)] * state).abs();
        let rounding = NOISE * end.state.iter().enumerate().map(term).sum::<f64>();
        velocity.f[j].abs() <= rounding || small(j, velocity.f[j].abs() * time)
    };
    Ok((0..reach.low.len()).all(still))
}
