//! A Poincaré diagram as JSON.

use super::work::Counts;
use super::{Named, Range, parameters, states, units};
use crate::model::ModelInfo;
use crate::study::{Case, DiagramRecord, Motion, Slice, SweepRecord};

/// A Poincaré diagram.
#[derive(serde::Serialize)]
pub(in crate::app) struct DiagramDocument<'a> {
    model: &'a str,
    dynamics: String,
    parameters: Named<'a, f64>,
    along: Range<'a>,
    section: String,
    settle: usize,
    sweeps: Vec<SweepDocument<'a>>,
    /// Values that are not there, of a diagram that was interrupted.
    #[serde(skip_serializing_if = "Option::is_none")]
    interrupted: Option<Missing>,
    units: Named<'a, &'static str>,
    work: Counts,
}

#[derive(serde::Serialize)]
struct Missing {
    missing: usize,
}

#[derive(serde::Serialize)]
struct SweepDocument<'a> {
    sweep: &'static str,
    values: Vec<Value<'a>>,
}

/// One value of the design variable.
#[derive(serde::Serialize)]
struct Value<'a> {
    r: f64,
    motion: String,
    period_count: Option<usize>,
    /// One column for each state.
    points: Named<'a, Vec<f64>>,
    min: Named<'a, f64>,
    max: Named<'a, f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    lyapunov: Option<Exponent<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<&'a str>,
}

/// A Lyapunov exponent: null without a failure where the motion is superstable.
#[derive(serde::Serialize)]
struct Exponent<'a> {
    exponent: Option<f64>,
    error: Option<f64>,
    time: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    failed: Option<&'a str>,
}

impl<'a> DiagramDocument<'a> {
    pub(in crate::app) fn new(info: &'a ModelInfo, case: &Case, record: &'a DiagramRecord) -> Self {
        let sweep = |sweep: &'a SweepRecord| SweepDocument {
            sweep: sweep.name,
            values: sweep.slices.iter().map(|s| Value::new(info, s)).collect(),
        };
        Self {
            model: info.command,
            dynamics: case.dynamics.to_string(),
            parameters: parameters(info, &case.parameters),
            along: Range::new(info, &record.along),
            section: record.diagram.section.describe(info),
            settle: record.diagram.settle,
            sweeps: record.sweeps.iter().map(sweep).collect(),
            interrupted: Some(record.missing)
                .filter(|missing| *missing > 0)
                .map(|missing| Missing { missing }),
            units: units(info),
            work: Counts::from(&record.work()),
        }
    }
}

impl<'a> Value<'a> {
    fn new(info: &'a ModelInfo, slice: &'a Slice) -> Self {
        let column = |j: usize| {
            let points = slice.points.iter();
            points.filter_map(|point| point.get(j).copied()).collect()
        };
        let (period_count, reason) = match &slice.motion {
            Motion::Periodic(count) => (Some(*count), None),
            Motion::Failed(reason) => (None, Some(reason.as_str())),
            _ => (None, None),
        };
        Self {
            r: slice.r,
            motion: slice.motion.name(),
            period_count,
            points: states(info, (0..info.states.len()).map(column)),
            min: states(info, slice.min.clone()),
            max: states(info, slice.max.clone()),
            lyapunov: slice.lyapunov.as_ref().map(|found| match found {
                Ok(found) => Exponent {
                    exponent: found.exponent,
                    error: Some(found.error).filter(|error| error.is_finite()),
                    time: Some(found.time),
                    failed: None,
                },
                Err(reason) => Exponent {
                    exponent: None,
                    error: None,
                    time: None,
                    failed: Some(reason),
                },
            }),
            reason,
        }
    }
}
