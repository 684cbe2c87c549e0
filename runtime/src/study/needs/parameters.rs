//! Which parameters a scene needs.

use std::ops::ControlFlow;

use super::stage::{Scene, Stage};
use crate::model::{Bound, Parameter};
use crate::study::question::Case;
use crate::study::system::System;

/// Share of its way by which a value stays inside a bound that it must not meet.
const INSIDE: f64 = 1e-3;

/// What a parameter matters.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterNeed {
    /// Its name.
    pub name: &'static str,
    /// Its value.
    pub value: f64,
    /// The values over which it was judged: its bounds, or from nothing to twice its value where it has none; nowhere if it
    /// is 0 and has none.
    pub over: Option<[f64; 2]>,
    /// The largest relative change of the answer for a unit of the parameter, by exact derivatives at all places; why there is
    /// none otherwise.
    pub sensitivity: Result<f64, String>,
    /// The largest error of the answer at both ends of these values, measured: where the derivative does not tell already
    /// that it is too large.
    pub error: Option<f64>,
    /// Whether it matters: whether the answer changes by more than the accuracy, or that could not be told.
    pub matters: bool,
}

impl System {
    /// What each parameter matters, but for what is followed and for what leaves modes out.
    pub(super) fn matters(
        &self,
        stage: &Stage,
        go_on: &mut dyn FnMut() -> ControlFlow<()>,
    ) -> Vec<ParameterNeed> {
        let modes = self.info().structures.iter().flat_map(|one| one.modes);
        let shares: Vec<usize> = modes.filter_map(|mode| mode.share).collect();
        let followed = stage.along.and_then(|along| along.design.parameter());
        let mut needs = Vec::new();
        for index in 0..self.info().parameters.len() {
            if shares.contains(&index) || followed == Some(index) {
                continue;
            }
            if go_on().is_break() {
                break;
            }
            needs.push(self.weighed(stage, index));
        }
        needs
    }

    fn weighed(&self, stage: &Stage, index: usize) -> ParameterNeed {
        let declared = &self.info().parameters[index];
        let value = stage
            .scenes
            .first()
            .map_or(declared.default, |scene| scene.case.parameters[index]);
        let over = over(declared, value);
        let mut sensitivity = Ok(0.0_f64);
        for scene in &stage.scenes {
            let here = self
                .sensitivity(scene, index)
                .map_err(|error| error.to_string());
            sensitivity = sensitivity.and_then(|known| here.map(|here| known.max(here)));
        }
        let way = over.map(|ends| {
            ends.map(|end| (end - value).abs())
                .into_iter()
                .fold(0.0, f64::max)
        });
        let little = match (&sensitivity, way) {
            (Ok(rate), Some(way)) => rate * way <= stage.accuracy,
            _ => false,
        };
        let error = over
            .filter(|_| little)
            .and_then(|ends| self.moved(stage, index, ends));
        ParameterNeed {
            name: declared.name,
            value,
            over,
            sensitivity,
            error,
            matters: error.is_none_or(|error| error > stage.accuracy),
        }
    }

    /// The largest error of the answer with a parameter at these values; `None` where no orbit was found with one.
    fn moved(&self, stage: &Stage, index: usize, ends: [f64; 2]) -> Option<f64> {
        let mut largest = 0.0_f64;
        for scene in &stage.scenes {
            for end in ends {
                largest = largest.max(self.moved_to(scene, index, end)?);
            }
        }
        Some(largest)
    }

    fn moved_to(&self, scene: &Scene, index: usize, value: f64) -> Option<f64> {
        if value == scene.case.parameters[index] {
            return Some(0.0);
        }
        let mut case: Case = scene.case.clone();
        case.parameters[index] = value;
        let (start, period) = (scene.orbit.place.state.clone(), scene.orbit.period);
        let found = self.nearby(case, start, period).ok()?;
        Some(scene.answer.error(&found.answer))
    }
}

/// The values over which a parameter is judged.
fn over(declared: &Parameter, value: f64) -> Option<[f64; 2]> {
    let bounds = declared.bounds;
    if value == 0.0 && (bounds.lower.is_none() || bounds.upper.is_none()) {
        return None;
    }
    let whole = bounds.lower.zip(bounds.upper);
    let wanted = match whole {
        Some((lower, upper)) => [lower.value, upper.value],
        None => [value - value.abs(), value + value.abs()],
    };
    let inside = |end: f64, bound: Option<Bound>, side: f64| match bound {
        Some(bound) if side * (end - bound.value) >= 0.0 => {
            let in_by = if bound.inclusive { 0.0 } else { INSIDE };
            bound.value + in_by * (value - bound.value)
        }
        _ => end,
    };
    Some([
        inside(wanted[0], bounds.lower, -1.0),
        inside(wanted[1], bounds.upper, 1.0),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Bounds;

    fn declared(lower: Option<(f64, bool)>, upper: Option<(f64, bool)>) -> Parameter {
        let bound = |(value, inclusive)| Bound { value, inclusive };
        Parameter {
            name: "p",
            doc: "",
            unit: None,
            default: 1.0,
            bounds: Bounds {
                lower: lower.map(bound),
                upper: upper.map(bound),
            },
        }
    }

    #[test]
    fn values_stay_within_bounds() {
        let positive = declared(Some((0.0, false)), None);
        assert_eq!(over(&positive, 2.0), Some([2e-3, 4.0]));
        assert_eq!(over(&declared(None, None), -2.0), Some([-4.0, 0.0]));
        let both = declared(Some((-1.0, true)), Some((3.0, true)));
        assert_eq!(over(&both, 0.0), Some([-1.0, 3.0]));
        assert_eq!(
            over(&declared(Some((1.5, true)), None), 2.0),
            Some([1.5, 4.0])
        );
        assert_eq!(over(&declared(Some((0.0, true)), None), 0.0), None);
    }
}
