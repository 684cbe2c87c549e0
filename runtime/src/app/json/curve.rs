//! A curve of special points in two parameters as JSON.

use super::work::Counts;
use super::{Named, Range, parameters, states, units};
use crate::model::ModelInfo;
use crate::study::{Along, Case, CurvePointRecord, CurveRecord};

/// A curve of special points.
#[derive(serde::Serialize)]
pub(in crate::app) struct CurveDocument<'a> {
    model: &'a str,
    dynamics: String,
    parameters: Named<'a, f64>,
    along: Range<'a>,
    and: Range<'a>,
    of: &'a str,
    kind: &'static str,
    points: Vec<Point<'a>>,
    special: Vec<Special<'a>>,
    ended: &'static str,
    reason: &'a str,
    units: Named<'a, &'static str>,
    work: Counts,
}

/// A special orbit.
#[derive(serde::Serialize)]
struct Point<'a> {
    /// Both parameters by name.
    at: Named<'a, f64>,
    period: f64,
    state: Named<'a, f64>,
    multipliers: Vec<[f64; 2]>,
    residual: f64,
    test: f64,
}

/// A point of codimension two.
#[derive(serde::Serialize)]
struct Special<'a> {
    kind: &'static str,
    label: &'a str,
    #[serde(flatten)]
    point: Point<'a>,
}

impl<'a> CurveDocument<'a> {
    pub(in crate::app) fn new(info: &'a ModelInfo, case: &Case, curve: &'a CurveRecord) -> Self {
        let ranges = [&curve.along, &curve.and];
        let special = curve.special.iter().map(|one| Special {
            kind: one.kind,
            label: &one.label,
            point: Point::new(info, ranges, &one.point),
        });
        let points = curve.points.iter();
        Self {
            model: info.command,
            dynamics: case.dynamics.to_string(),
            parameters: parameters(info, &case.parameters),
            along: Range::new(info, &curve.along),
            and: Range::new(info, &curve.and),
            of: &curve.of,
            kind: curve.kind,
            points: points.map(|one| Point::new(info, ranges, one)).collect(),
            special: special.collect(),
            ended: curve.ended.word(),
            reason: &curve.ended.reason,
            units: units(info),
            work: Counts::from(&curve.work),
        }
    }
}

impl<'a> Point<'a> {
    fn new(info: &'a ModelInfo, ranges: [&Along; 2], point: &CurvePointRecord) -> Self {
        let names = ranges.map(|range| range.name(info));
        Self {
            at: Named::new(names.into_iter(), [point.p, point.q]),
            period: point.period,
            state: states(info, point.state.clone()),
            multipliers: point.multipliers.iter().map(|m| [m.re, m.im]).collect(),
            residual: point.residual,
            test: point.test,
        }
    }
}
