//! Following a curve of orbits on a border between two orders of events.

use std::ops::ControlFlow;

use super::codimension::window;
use super::follow::Curve;
use super::plane::Plane;
use super::point::moved;
use crate::continuation::{
    self, Branch, Failure, Kind, Lost, Monitor, Point, Reader, Settings, Started, Watched,
};
use crate::field::Work;
use crate::flow::FlowError;
use crate::shooting::{Border, BorderProblem, BorderShot, Orbit, borders};

/// Share of its range by which the first variable of a border may be off the point from which it is followed.
const SAME: f64 = 1e-3;

/// An orbit on a border, and where.
#[derive(Debug, Clone, PartialEq)]
pub struct BorderPoint {
    /// The first design variable.
    pub p: f64,
    /// The second one.
    pub q: f64,
    /// What its curve measures q in.
    pub q_scale: f64,
    /// The orbit.
    pub shot: BorderShot,
    /// Which border it is on.
    pub kind: Kind,
    /// Norm of the residual of its equations.
    pub residual: f64,
    /// Component of the unit tangent along q, in scaled coordinates.
    pub slope: f64,
}

impl Watched for BorderPoint {
    fn r(&self) -> f64 {
        self.q
    }

    fn r_scale(&self) -> f64 {
        self.q_scale
    }

    fn slope(&self) -> f64 {
        self.slope
    }

    fn moved(&self, from: &Self) -> f64 {
        moved([self.p, self.q], [from.p, from.q])
    }
}

/// Follows the border of this kind that `orbit` nearly meets at (p, q = settings.from) as [`follow`](super::follow) does; `None`
/// if it is near to none.
///
/// # Errors
/// The first point cannot be converged on.
pub fn follow_border(
    plane: &Plane,
    (kind, orbit): (Kind, &Orbit),
    p: f64,
    window: [f64; 2],
    settings: Settings,
    watch: &mut dyn FnMut(&BorderPoint) -> ControlFlow<()>,
) -> Result<Option<Curve<BorderPoint>>, Failure<FlowError>> {
    let flow = plane.at(p, settings.from).map_err(Failure::Evaluation)?;
    let near = borders(flow.as_ref(), orbit).map_err(Failure::Evaluation)?;
    let plane = Plane {
        family: plane.family.with_magnitude(&orbit.magnitude()),
        designs: plane.designs,
    };
    let wide = (window[1] - window[0]).abs();
    let scales = [wide, (settings.to - settings.from).abs()];
    let start = |border| -> Result<Started<BorderProblem<Plane>>, Failure<FlowError>> {
        let problem = BorderProblem::new(plane.clone(), orbit, border, scales);
        let problem = problem.ok_or(Failure::Singular { r: settings.from })?;
        let z = problem.unknowns(p);
        Branch::start(problem, z, settings)
    };
    let reader = Along { window, kind };
    let is_it = |(branch, point): &Started<_>| {
        let found = reader.read(&branch.problem, point, Work::default());
        found.kind == kind && (found.p - p).abs() <= SAME * wide
    };
    let mut failed = None;
    for border in near.into_iter().filter(|one: &Border| one.may_be(kind)) {
        match start(border) {
            Ok(started) if is_it(&started) => {
                return Ok(Some(continuation::follow(reader, started, settings, watch)));
            }
            Ok(_) => (),
            Err(failure) => failed = failed.or(Some(failure)),
        }
    }
    failed.map_or(Ok(None), Err)
}

/// Reads orbits on a border of one kind off their unknowns.
#[derive(Clone)]
struct Along {
    window: [f64; 2],
    kind: Kind,
}

impl Reader for Along {
    type Problem = BorderProblem<Plane>;
    type Point = BorderPoint;

    fn read(
        &self,
        problem: &BorderProblem<Plane>,
        point: &Point<BorderShot>,
        _work: Work,
    ) -> BorderPoint {
        let count = point.z.len();
        BorderPoint {
            p: point.z[count - 1],
            q: point.r,
            q_scale: point.r_scale,
            shot: point.extra.clone(),
            kind: problem.border.kind(point.extra.inwards),
            residual: point.residual,
            slope: point.tangent[count],
        }
    }

    fn monitors(&self) -> Vec<Monitor<'_, BorderPoint>> {
        window(self.window, |point: &BorderPoint| point.p).collect()
    }

    /// What touches is largest there, and not least, or the force that could hold the contact goes the other way.
    fn lost(&self, point: &BorderPoint) -> Option<Lost> {
        let other = (point.kind != self.kind).then_some(Lost::Becomes(point.kind));
        other.or_else(|| (!point.shot.least).then_some(Lost::Largest))
    }

    fn work(problem: &BorderProblem<Plane>) -> Work {
        problem.work
    }
}
