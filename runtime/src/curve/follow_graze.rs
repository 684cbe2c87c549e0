//! Following a curve of grazing orbits.

use std::ops::ControlFlow;

use super::follow::End;
use super::grazing::{Graze, GrazingProblem, GrazingShot};
use super::plane::Plane;
use crate::continuation::{Branch, Ending, Failure, Point, Settings, root};
use crate::field::Work;
use crate::flow::FlowError;
use crate::shooting::Orbit;

/// A grazing orbit, and where.
#[derive(Debug, Clone, PartialEq)]
pub struct GrazingPoint {
    /// The first design variable.
    pub p: f64,
    /// The second one.
    pub q: f64,
    /// The orbit.
    pub shot: GrazingShot,
    /// Norm of the residual of its equations.
    pub residual: f64,
}

/// A curve of grazing orbits.
#[derive(Debug, Clone)]
pub struct GrazingCurve {
    /// Its points in the order in which they were found.
    pub points: Vec<GrazingPoint>,
    /// Why it ended.
    pub end: End,
    /// What it cost.
    pub work: Work,
}

/// Follows the graze that `orbit` nearly meets at (p, q = settings.from) as [`follow`](super::follow) does; `None` if no
/// contact of it slides.
///
/// # Errors
/// The first point cannot be converged on.
pub fn follow_graze(
    plane: &Plane,
    orbit: &Orbit,
    p: f64,
    window: [f64; 2],
    settings: Settings,
    watch: &mut dyn FnMut(&GrazingPoint) -> ControlFlow<()>,
) -> Result<Option<GrazingCurve>, Failure<FlowError>> {
    let Some(graze) = Graze::of(orbit) else {
        return Ok(None);
    };
    let scales = [
        (window[1] - window[0]).abs(),
        (settings.to - settings.from).abs(),
    ];
    let plane = Plane {
        family: plane.family.with_magnitude(&orbit.magnitude()),
        designs: plane.designs,
    };
    let problem = GrazingProblem::new(plane, orbit, graze, scales);
    let z = problem.unknowns(p);
    let (mut branch, first) = Branch::start(problem, z, settings)?;
    let bounds = [window[0].min(window[1]), window[0].max(window[1])];
    let mut points: Vec<GrazingPoint> = Vec::new();
    let mut next = Some(first);
    let mut end = None;
    while let (Some(point), None) = (next.take(), &end) {
        let mut here = grazing(&point);
        if !here.shot.least {
            end = Some(End::Lost(here.shot.rate.abs()));
            break;
        }
        if let (Some(before), Some(link)) = (points.last(), branch.link())
            && let Some(bound) = bounds
                .into_iter()
                .find(|b| (before.p - b) * (here.p - b) < 0.0)
        {
            let mut link = link.clone();
            root(before.p - bound, here.p - bound, |share| {
                here = grazing(&link.between(share).ok()?);
                Some(here.p - bound)
            });
            end = Some(End::Window);
        }
        if watch(&here).is_break() {
            end.get_or_insert(End::Stopped);
        }
        points.push(here);
        if end.is_none() {
            next = branch.next();
        }
    }
    let ending = || branch.ending().cloned().unwrap_or(Ending::TooManyPoints);
    Ok(Some(GrazingCurve {
        points,
        end: end.unwrap_or_else(|| End::Followed(ending())),
        work: branch.problem.work,
    }))
}

fn grazing(point: &Point<GrazingShot>) -> GrazingPoint {
    GrazingPoint {
        p: point.z[point.z.len() - 1],
        q: point.r,
        shot: point.extra.clone(),
        residual: point.residual,
    }
}
