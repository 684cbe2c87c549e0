//! The motion to which a system settles: where it meets the section, and what kind of motion that makes it.

use std::f64::consts::TAU;

use super::kind::Motion;
use super::setting::Diagram;
use crate::field::Work;
use crate::flow::FlowError;
use crate::motion::{Flow, Place};
use crate::poincare::{Crossings, Horizon, Reason, Silence, approaches, recurrence};
use crate::shooting::Shifts;

/// Points of a section that agree to this share of the motion's extent are one.
const SAME_POINT: f64 = 1e-5;
/// A motion whose extent is this share of its usual size is at rest.
const REST: f64 = 1e-6;

/// How often a motion that is settling is given as much time again.
const ROUNDS: usize = 40;

/// A motion that has settled.
pub(super) struct Watched {
    pub(super) motion: Motion,
    pub(super) points: Vec<Vec<f64>>,
    /// How many of the points are different ones.
    pub(super) different: usize,
    pub(super) silence: Option<Silence>,
    pub(super) place: Place,
    pub(super) min: Vec<f64>,
    pub(super) max: Vec<f64>,
    /// Mean time from point to point.
    pub(super) lap: f64,
    pub(super) work: Work,
}

impl Watched {
    /// Lets the motion from `start` settle, and notes its points; its states are measured against `usual` sizes. One that has
    /// not settled by then, but comes nearer to it, is given more time.
    pub(super) fn from(
        flow: &dyn Flow,
        start: Place,
        diagram: &Diagram,
        usual: &[f64],
    ) -> Result<Self, FlowError> {
        let crossings = Crossings::new(flow, start, diagram.section, Horizon::Recurrence)?;
        let mut crossings = crossings.among(usual);
        let mut seen = Self::seen(flow, &mut crossings, diagram, usual)?;
        let further = Diagram {
            settle: 0,
            ..*diagram
        };
        for _ in 0..ROUNDS {
            if seen.motion != Motion::Settling {
                break;
            }
            crossings.forget();
            seen = Self::seen(flow, &mut crossings, &further, usual)?;
        }
        Ok(seen)
    }

    /// What the next points show.
    fn seen(
        flow: &dyn Flow,
        crossings: &mut Crossings<'_>,
        diagram: &Diagram,
        usual: &[f64],
    ) -> Result<Self, FlowError> {
        let (mut points, times) = gather(crossings, diagram)?;
        let missing = points.len() < diagram.points;
        let silence = crossings.silence().filter(|_| missing);
        let (time, place) = crossings.place();
        let (min, max) = bounds(crossings, silence.as_ref());
        let extent: Vec<f64> = max.iter().zip(&min).map(|(max, min)| max - min).collect();
        let whole = crossings.extent();
        let size = |j: usize| min[j].abs().max(max[j].abs()).max(usual[j]).max(whole[j]);
        let rests = (0..extent.len()).all(|j| extent[j] <= REST * size(j));
        let (motion, different) = match (rests, &silence) {
            (true, _) => (Motion::Rest, 1),
            (false, Some(_)) => (Motion::Elsewhere, 0),
            (false, None) => counted(flow, &place, (&points, &times), &extent)?,
        };
        match motion {
            Motion::Rest => points = vec![place.state.clone()],
            Motion::Elsewhere => points.clear(),
            _ => {}
        }
        Ok(Self {
            lap: lap(&times, different).unwrap_or(time),
            silence: silence.filter(|_| motion == Motion::Elsewhere),
            work: crossings.work,
            motion,
            points,
            different,
            place,
            min,
            max,
        })
    }
}

/// The points after those that are left out, and the times of all.
fn gather(
    crossings: &mut Crossings<'_>,
    diagram: &Diagram,
) -> Result<(Vec<Vec<f64>>, Vec<f64>), FlowError> {
    let (mut points, mut times) = (Vec::new(), Vec::new());
    for k in 0..diagram.settle + diagram.points {
        if k == diagram.settle {
            crossings.forget();
        }
        let Some(crossing) = crossings.next() else {
            break;
        };
        let crossing = crossing?;
        times.push(crossing.time);
        if k >= diagram.settle {
            points.push(crossing.state);
        }
    }
    Ok((points, times))
}

/// How far the motion went while points were taken, or while none came.
fn bounds(crossings: &Crossings<'_>, silence: Option<&Silence>) -> (Vec<f64>, Vec<f64>) {
    match silence {
        Some(silence) if silence.reason == Reason::Rest => {
            let (_, place) = crossings.place();
            (place.state.clone(), place.state)
        }
        Some(silence) => (silence.low.clone(), silence.high.clone()),
        None => crossings.range(),
    }
}

/// What points at these times show of a motion of this extent, and how many of them are different.
fn counted(
    flow: &dyn Flow,
    place: &Place,
    (points, times): (&[Vec<f64>], &[f64]),
    extent: &[f64],
) -> Result<(Motion, usize), FlowError> {
    let phase = flow.phase();
    let came = recurrence(points, extent, phase, SAME_POINT);
    let still = came
        .is_none()
        .then(|| still(flow, points, extent))
        .flatten();
    let (points, extent) = match &still {
        Some((points, extent)) => (points.as_slice(), extent.as_slice()),
        None => (points, extent),
    };
    let count = came.or_else(|| recurrence(points, extent, phase, SAME_POINT));
    // What settles to and fro is near to a return after two turns before it is after one.
    if approaches(points, extent, phase, count) {
        return Ok((Motion::Settling, points.len()));
    }
    let Some(count) = count else {
        return Ok((Motion::Aperiodic, points.len()));
    };
    let turns = turns(flow, place, times, count)?;
    Ok((Motion::Periodic(turns), count))
}

/// The points of a motion that runs on as they would be if it did not, and what they are measured against: where it runs, what
/// it gains from one to the next. `None` if it does not.
fn still(
    flow: &dyn Flow,
    points: &[Vec<f64>],
    extent: &[f64],
) -> Option<(Vec<Vec<f64>>, Vec<f64>)> {
    let moves = |extent: &f64| if *extent > 0.0 { *extent } else { 1.0 };
    let usual: Vec<f64> = extent.iter().map(moves).collect();
    let shifts = Shifts::of(flow, &usual);
    let first = points.first().filter(|_| !shifts.is_empty())?;
    let mut gains = vec![0.0_f64; extent.len()];
    for pair in points.windows(2) {
        let shift = shifts.between(&pair[0], &pair[1]);
        let larger = gains.iter_mut().zip(&shift);
        larger.for_each(|(most, gain)| *most = most.max(gain.abs()));
    }
    if gains.iter().all(|gain| *gain == 0.0) {
        return None;
    }
    let home = |point: &Vec<f64>| {
        let shift = shifts.between(first, point);
        point.iter().zip(&shift).map(|(y, gain)| y - gain).collect()
    };
    let sizes = gains.iter().zip(extent);
    let sizes = sizes.map(|(gain, extent)| if *gain > 0.0 { *gain } else { *extent });
    Some((points.iter().map(home).collect(), sizes.collect()))
}

/// The n of a motion that comes back after this many points: of a driven one, how often the drive turns meanwhile.
fn turns(flow: &dyn Flow, place: &Place, times: &[f64], count: usize) -> Result<usize, FlowError> {
    let (Some(phase), Some(lap)) = (flow.phase(), lap(times, count)) else {
        return Ok(count);
    };
    let turned = flow.velocity(place)?.f[phase] * lap * count as f64 / TAU;
    Ok((turned.round() as usize).max(1))
}

/// Mean time from point to point over the last returns to this many points.
fn lap(times: &[f64], count: usize) -> Option<f64> {
    let turns = count.clamp(1, times.len().max(2) - 1);
    let last = &times[times.len().checked_sub(turns + 1)?..];
    match last {
        [first, .., last] => Some((last - first) / turns as f64),
        _ => None,
    }
}
