//! Following a curve of grazing orbits.

use std::ops::ControlFlow;

use super::codimension::window;
use super::follow::Curve;
use super::plane::Plane;
use super::point::moved;
use crate::continuation::{self, Branch, Failure, Monitor, Point, Reader, Settings, Watched};
use crate::field::Work;
use crate::flow::FlowError;
use crate::shooting::{Border, BorderProblem, BorderShot, Orbit, borders};

/// A grazing orbit, and where.
#[derive(Debug, Clone, PartialEq)]
pub struct GrazingPoint {
    /// The first design variable.
    pub p: f64,
    /// The second one.
    pub q: f64,
    /// The orbit.
    pub shot: BorderShot,
    /// Norm of the residual of its equations.
    pub residual: f64,
    /// Component of the unit tangent along q, in scaled coordinates.
    pub slope: f64,
}

impl Watched for GrazingPoint {
    fn r(&self) -> f64 {
        self.q
    }

    fn slope(&self) -> f64 {
        self.slope
    }

    fn moved(&self, from: &Self) -> f64 {
        moved([self.p, self.q], [from.p, from.q])
    }
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
) -> Result<Option<Curve<GrazingPoint>>, Failure<FlowError>> {
    let flow = plane.at(p, settings.from).map_err(Failure::Evaluation)?;
    let near = borders(flow.as_ref(), orbit).map_err(Failure::Evaluation)?;
    let Some(graze) = near.into_iter().find(Border::is_graze) else {
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
    let problem = BorderProblem::new(plane, orbit, graze, scales);
    let problem = problem.ok_or(Failure::Singular { r: settings.from })?;
    let z = problem.unknowns(p);
    let started = Branch::start(problem, z, settings)?;
    Ok(Some(continuation::follow(
        Grazing { window },
        started,
        settings,
        watch,
    )))
}

/// Reads grazing orbits off their unknowns.
#[derive(Clone)]
struct Grazing {
    window: [f64; 2],
}

impl Reader for Grazing {
    type Problem = BorderProblem<Plane>;
    type Point = GrazingPoint;

    fn read(
        &self,
        _problem: &BorderProblem<Plane>,
        point: &Point<BorderShot>,
        _work: Work,
    ) -> GrazingPoint {
        let count = point.z.len();
        GrazingPoint {
            p: point.z[count - 1],
            q: point.r,
            shot: point.extra.clone(),
            residual: point.residual,
            slope: point.tangent[count],
        }
    }

    fn monitors(&self) -> Vec<Monitor<'_, GrazingPoint>> {
        window(self.window, |point: &GrazingPoint| point.p).collect()
    }

    /// Whether the speed of the contact is largest there, and not least.
    fn lost(&self, point: &GrazingPoint) -> Option<f64> {
        (!point.shot.least).then(|| point.shot.rate.abs())
    }

    fn work(problem: &BorderProblem<Plane>) -> Work {
        problem.work
    }
}
