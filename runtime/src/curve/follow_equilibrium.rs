//! Following a curve of equilibria with an eigenvalue on the imaginary axis.

use std::ops::ControlFlow;

use nalgebra::DVector;

use super::codimension::window as bounds;
use super::codimension_equilibrium::monitors;
use super::condition::Condition;
use super::critical::{Critical, CriticalProblem, joined, split};
use super::follow::Curve;
use super::isola::Unfolding;
use super::plane::Plane;
use super::point::{CriticalEquilibrium, CurvePoint};
use crate::continuation::{self, Branch, Failure, Kind, Monitor, Reader, Settings};
use crate::equilibrium::{EquilibriumProblem, Onset};
use crate::field::Work;
use crate::flow::FlowError;
use crate::motion::{Place, Velocity};

type Point = CurvePoint<CriticalEquilibrium>;

/// Follows the fold or Hopf point `kind` of equilibria that lies at `from` for (p, q = settings.from) as
/// [`follow`](super::follow) does that of orbits; `None` if there is no condition for that kind.
///
/// # Errors
/// The first point cannot be converged on.
pub fn follow_equilibrium(
    plane: &Plane,
    kind: Kind,
    (from, p): (&Place, f64),
    window: [f64; 2],
    settings: Settings,
    watch: &mut dyn FnMut(&Point) -> ControlFlow<()>,
) -> Result<Option<Curve<Point>>, Failure<FlowError>> {
    let Some(condition) = Condition::of_equilibria(kind) else {
        return Ok(None);
    };
    let q = settings.from;
    let scales = [
        (window[1] - window[0]).abs(),
        (settings.to - settings.from).abs(),
    ];
    let subject = EquilibriumProblem::new(plane.along_p(q), p, from);
    let unfolding = Unfolding {
        plane: plane.clone(),
        scales,
    };
    let mut problem = CriticalProblem::new(plane.clone(), subject, condition, scales);
    let z = joined(&DVector::from_column_slice(&from.state), p);
    problem.align(&z, q).map_err(Failure::Evaluation)?;
    let started = Branch::start(problem, z, settings)?;
    let reader = Equilibria {
        kind,
        window,
        unfolding,
    };
    Ok(Some(continuation::follow(reader, started, settings, watch)))
}

/// Reads critical equilibria off their unknowns.
#[derive(Clone)]
struct Equilibria {
    kind: Kind,
    window: [f64; 2],
    unfolding: Unfolding,
}

impl Reader for Equilibria {
    type Problem = CriticalProblem<EquilibriumProblem>;
    type Point = Point;

    fn read(
        &self,
        problem: &Self::Problem,
        point: &continuation::Point<Critical<Velocity>>,
        _work: Work,
    ) -> Point {
        let (z, p) = split(&point.z);
        let velocity = &point.extra.of;
        let place = problem.subject.place(&z);
        let pair = problem.condition().followed(&velocity.jacobian);
        let turns = pair.map(|[one, _]| one.im.abs()).filter(|im| *im > 0.0);
        let flow = problem.plane.at(p, point.r).ok();
        let onset = flow.as_ref().zip(turns);
        let onset = onset.and_then(|(flow, turns)| Onset::of(flow.as_ref(), &place, turns));
        let count = z.len();
        let of = CriticalEquilibrium {
            spectrum: problem.subject.spectrum(flow.as_deref(), &place, velocity),
            pair,
            onset,
            margins: flow.map_or_else(Vec::new, |flow| flow.margins(&place)),
            place,
            residual: point.residual,
        };
        CurvePoint {
            p,
            q: point.r,
            q_scale: point.r_scale,
            of,
            test: point.extra.test,
            tangent: [point.tangent[count], point.tangent[count + 1]],
            still: None,
        }
    }

    fn monitors(&self) -> Vec<Monitor<'_, Point>> {
        let bounds = bounds(self.window, |point: &Point| point.p);
        bounds.chain(monitors(self.kind, &self.unfolding)).collect()
    }

    fn work(problem: &Self::Problem) -> Work {
        problem.subject.work
    }
}
