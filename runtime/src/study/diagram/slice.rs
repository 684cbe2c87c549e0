//! One value of a diagram: the motion to which the system settles there.

use serde::{Deserialize, Serialize};

use super::setting::Diagram;
use crate::equilibrium::Spectrum;
use crate::field::Work;
use crate::flow::FlowError;
use crate::lyapunov::{Lyapunov, lyapunov};
use crate::motion::{Family, Flow, Place, Velocity, sticking};
use crate::poincare::{Crossings, recurrence};
use crate::study::Along;

/// Points of a section that agree to this share of the motion's extent are one.
const SAME_POINT: f64 = 1e-5;
/// A motion whose extent is this share of its usual size is at rest.
const REST: f64 = 1e-6;

/// What is seen at one value of the design variable.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Slice {
    /// The design variable, in the user's own values.
    pub r: f64,
    /// What kind of motion it is.
    pub motion: Motion,
    /// Where it meets the section, in the order of time; where it rests, that one state.
    pub points: Vec<Vec<f64>>,
    /// Smallest value of each state while points were taken.
    pub min: Vec<f64>,
    /// Largest value of each state.
    pub max: Vec<f64>,
    /// Where it was when the last point was taken; nothing if it failed.
    pub end: Vec<f64>,
    /// The largest Lyapunov exponent across the motion, if it was wanted and has a value.
    pub lyapunov: Option<Result<Lyapunov, String>>,
    /// What it cost.
    pub work: Work,
}

/// The kind of a motion, as far as its points on a section tell.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub enum Motion {
    /// It comes back after this many points.
    Periodic(usize),
    /// It has not come back within half of the points taken.
    Aperiodic,
    /// It rests.
    Rest,
    /// It moves, but does not meet the section.
    Elsewhere,
    /// It could not be followed; why.
    Failed(String),
}

impl Motion {
    /// In a word or two: `period-3`, `aperiodic`, `rest`, `elsewhere`, `failed`.
    #[must_use]
    pub fn name(&self) -> String {
        match self {
            Self::Periodic(count) => format!("period-{count}"),
            Self::Aperiodic => "aperiodic".to_owned(),
            Self::Rest => "rest".to_owned(),
            Self::Elsewhere => "elsewhere".to_owned(),
            Self::Failed(_) => "failed".to_owned(),
        }
    }
}

/// Makes slices of a family.
pub(super) struct Cut<'a> {
    pub(super) family: &'a Family,
    pub(super) diagram: &'a Diagram,
    pub(super) along: Along,
    pub(super) start: &'a [f64],
}

/// A slice under way.
struct Seen {
    motion: Motion,
    points: Vec<Vec<f64>>,
    place: Place,
    min: Vec<f64>,
    max: Vec<f64>,
    /// Mean time from point to point.
    lap: f64,
    work: Work,
}

impl Cut<'_> {
    /// The slice at r, in the family's own count, from the declared start.
    pub(super) fn fresh(&self, r: f64) -> Slice {
        self.slice(r, self.start, &magnitude(self.start))
    }

    /// The slice at r from `start`; states are measured against `scale`.
    pub(super) fn slice(&self, r: f64, start: &[f64], scale: &[f64]) -> Slice {
        match self.seen(r, start, scale) {
            Ok((seen, lyapunov)) => Slice {
                r: self.along.value(r),
                motion: seen.motion,
                points: seen.points,
                min: seen.min,
                max: seen.max,
                end: seen.place.state,
                lyapunov,
                work: seen.work,
            },
            Err(error) => self.failed(r, &error),
        }
    }

    fn failed(&self, r: f64, error: &FlowError) -> Slice {
        Slice {
            r: self.along.value(r),
            motion: Motion::Failed(error.to_string()),
            points: Vec::new(),
            min: Vec::new(),
            max: Vec::new(),
            end: Vec::new(),
            lyapunov: None,
            work: Work::default(),
        }
    }

    fn seen(
        &self,
        r: f64,
        start: &[f64],
        scale: &[f64],
    ) -> Result<(Seen, Option<Result<Lyapunov, String>>), FlowError> {
        let flow = self.family.with_magnitude(scale).at(r)?;
        let seen = self.watch(&*flow, flow.place(start)?, scale)?;
        let exponent = match self.diagram.lyapunov {
            Some(laps) => self.exponent(&*flow, &seen, laps)?,
            None => None,
        };
        Ok((seen, exponent))
    }

    fn exponent(
        &self,
        flow: &dyn Flow,
        seen: &Seen,
        laps: usize,
    ) -> Result<Option<Result<Lyapunov, String>>, FlowError> {
        let place = &seen.place;
        let found = match seen.motion {
            Motion::Elsewhere | Motion::Failed(_) => return Ok(None),
            Motion::Rest => Ok(at_rest(flow, place)?),
            Motion::Aperiodic => lyapunov(flow, place.clone(), seen.lap, laps),
            // Over whole periods the rate of a periodic motion does not fluctuate.
            Motion::Periodic(count) => {
                let period = seen.lap * count as f64;
                lyapunov(flow, place.clone(), period, laps.div_ceil(count))
            }
        };
        Ok(Some(found.map_err(|error| error.to_string())))
    }

    /// Lets the motion settle and notes its points.
    fn watch(&self, flow: &dyn Flow, start: Place, scale: &[f64]) -> Result<Seen, FlowError> {
        let Diagram {
            section,
            settle,
            points: wanted,
            ..
        } = *self.diagram;
        let mut crossings = Crossings::new(flow, start, section)?;
        let (mut points, mut times) = (Vec::new(), Vec::new());
        for k in 0..settle + wanted {
            if k == settle {
                crossings.forget();
            }
            let Some(crossing) = crossings.next() else {
                break;
            };
            let crossing = crossing?;
            times.push(crossing.time);
            if k >= settle {
                points.push(crossing.state);
            }
        }
        let (time, place) = crossings.place();
        let (mut min, mut max) = crossings.range();
        let mut work = crossings.work;
        if points.len() < wanted {
            // What goes on without crossing: its range since it last crossed.
            crossings.forget();
            crossings.watch_on()?;
            (min, max) = crossings.range();
            work = crossings.work;
        }
        let extent: Vec<f64> = max.iter().zip(&min).map(|(max, min)| max - min).collect();
        let size = |j: usize| min[j].abs().max(max[j].abs()).max(scale[j]);
        let motion = if (0..extent.len()).all(|j| extent[j] <= REST * size(j)) {
            points = vec![place.state.clone()];
            Motion::Rest
        } else if points.len() < wanted {
            points.clear();
            Motion::Elsewhere
        } else {
            recurrence(&points, &extent, SAME_POINT).map_or(Motion::Aperiodic, Motion::Periodic)
        };
        let turns = match motion {
            Motion::Periodic(count) => count,
            _ => points.len().saturating_sub(1).max(1),
        };
        let last = times.len().checked_sub(turns + 1).map(|i| &times[i..]);
        let lap = match last {
            Some([first, .., last]) => (last - first) / turns as f64,
            _ => time,
        };
        Ok(Seen {
            motion,
            points,
            place,
            min,
            max,
            lap,
            work,
        })
    }
}

/// The largest exponent of a state of rest: an eigenvalue's real part.
fn at_rest(flow: &dyn Flow, place: &Place) -> Result<Lyapunov, FlowError> {
    let Velocity { jacobian, lost, .. } = flow.velocity(place)?;
    let spectrum = Spectrum::across(&jacobian, sticking(&place.modes) + lost);
    Ok(Lyapunov {
        exponent: spectrum.eigenvalues.first().map(|value| value.re),
        error: 0.0,
        time: 0.0,
    })
}

/// Magnitudes as far as a start shows them.
pub(super) fn magnitude(start: &[f64]) -> Vec<f64> {
    let largest = start.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let other = if largest > 0.0 { largest } else { 1.0 };
    let size = |&x: &f64| if x == 0.0 { other } else { x.abs() };
    start.iter().map(size).collect()
}
