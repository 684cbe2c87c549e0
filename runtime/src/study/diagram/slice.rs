//! One value of a diagram: the motion to which the system settles there.

use serde::{Deserialize, Serialize};

use super::kind::Motion;
use super::setting::Diagram;
use super::watched::Watched;
use crate::equilibrium::Spectrum;
use crate::field::Work;
use crate::flow::FlowError;
use crate::lyapunov::{Lyapunov, lyapunov};
use crate::motion::{Family, Flow, Place, Velocity, sticking};
use crate::poincare::Silence;
use crate::study::Along;

/// Of magnitudes that nothing has shown, what the integrator resolves.
const UNKNOWN: f64 = 1e-3;

/// What is seen at one value of the design variable.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Slice {
    /// The design variable, in the user's own values.
    pub r: f64,
    /// What kind of motion it is.
    pub motion: Motion,
    /// Where it meets the section, in the order of time; where it rests, that one state.
    pub points: Vec<Vec<f64>>,
    /// How many of them are different ones.
    pub different: usize,
    /// What was seen of a motion that is elsewhere.
    pub silence: Option<Silence>,
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

impl Slice {
    /// Whether it can belong to a system with so many states.
    #[must_use]
    pub fn is_of(&self, order: usize) -> bool {
        let whole = |values: &Vec<f64>| {
            values.len() == order && values.iter().all(|value| value.is_finite())
        };
        let failed = matches!(self.motion, Motion::Failed(_));
        let ends = [&self.min, &self.max, &self.end].into_iter();
        let silent = self
            .silence
            .iter()
            .flat_map(|silence| [&silence.low, &silence.high]);
        let known = ends.clone().chain(silent).chain(&self.points).all(whole);
        let empty = self.points.is_empty() && ends.clone().all(|end| end.is_empty());
        self.different <= self.points.len() && if failed { empty } else { known }
    }
}

/// Makes slices of a family.
pub(super) struct Cut<'a> {
    pub(super) family: &'a Family,
    pub(super) diagram: &'a Diagram,
    pub(super) along: Along,
}

impl Cut<'_> {
    /// The slice at r, in the family's own count, from the first of these starts at which a motion can begin; states are
    /// measured against `scale`.
    pub(super) fn slice(&self, r: f64, starts: [&[f64]; 3], scale: &[f64]) -> Slice {
        match self.seen(r, starts, scale) {
            Ok((seen, lyapunov)) => Slice {
                different: seen.different,
                silence: seen.silence,
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
            different: 0,
            silence: None,
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
        starts: [&[f64]; 3],
        scale: &[f64],
    ) -> Result<(Watched, Option<Result<Lyapunov, String>>), FlowError> {
        let flow = self.family.with_magnitude(scale).at(r)?;
        let [start, others @ ..] = starts;
        let usual = usual(start, scale);
        let place = flow.place(start).or_else(|error| {
            let mut others = others.iter().map(|other| flow.place(other));
            others.find_map(Result::ok).ok_or(error)
        })?;
        let mut seen = Watched::from(&*flow, place, self.diagram, &usual)?;
        let exponent = match self.diagram.lyapunov {
            Some(laps) => self.exponent(&*flow, &seen, laps)?,
            None => None,
        };
        let attracts = exponent.as_ref().and_then(|found| found.as_ref().ok());
        if seen.motion == Motion::Aperiodic && attracts.is_some_and(Lyapunov::attracts) {
            // What motions beside it come to and does not come back is on its way to something that does.
            seen.motion = Motion::Settling;
        }
        Ok((seen, exponent))
    }

    fn exponent(
        &self,
        flow: &dyn Flow,
        seen: &Watched,
        laps: usize,
    ) -> Result<Option<Result<Lyapunov, String>>, FlowError> {
        let place = &seen.place;
        let found = match seen.motion {
            Motion::Elsewhere | Motion::Failed(_) => return Ok(None),
            Motion::Rest => Ok(at_rest(flow, place)?),
            Motion::Aperiodic | Motion::Settling => lyapunov(flow, place.clone(), seen.lap, laps),
            // Over whole periods the rate of a periodic motion does not fluctuate.
            Motion::Periodic(_) => {
                let period = seen.lap * seen.different as f64;
                lyapunov(flow, place.clone(), period, laps.div_ceil(seen.different))
            }
        };
        Ok(Some(found.map_err(|error| error.to_string())))
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

/// Sizes against which a motion is judged to rest: a start at the origin shows none.
fn usual(start: &[f64], scale: &[f64]) -> Vec<f64> {
    let shown = start.iter().any(|x| *x != 0.0);
    let share = if shown { 1.0 } else { UNKNOWN };
    scale.iter().map(|size| share * size).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seen() -> Slice {
        Slice {
            r: 1.0,
            motion: Motion::Periodic(1),
            points: vec![vec![1.0, 2.0]; 3],
            different: 1,
            silence: None,
            min: vec![0.0, 1.0],
            max: vec![2.0, 3.0],
            end: vec![1.0, 2.0],
            lyapunov: None,
            work: Work::default(),
        }
    }

    #[test]
    fn a_slice_belongs_to_as_many_states() {
        assert!(seen().is_of(2) && !seen().is_of(1) && !seen().is_of(3));
        let changes: [fn(&mut Slice); 5] = [
            |slice| slice.different = 4,
            |slice| slice.points[1].clear(),
            |slice| slice.min[0] = f64::NAN,
            |slice| slice.end.push(0.0),
            |slice| slice.motion = Motion::Failed("why".to_owned()),
        ];
        for change in changes {
            let mut changed = seen();
            change(&mut changed);
            assert!(!changed.is_of(2), "{changed:?}");
        }
    }
}
