//! Following a curve of orbits with a multiplier on the unit circle.

use std::ops::ControlFlow;

use super::codimension::{monitors, window as bounds};
use super::condition::Condition;
use super::critical::{Critical, CriticalProblem, joined, split};
use super::isola::Unfolding;
use super::plane::Plane;
use super::point::CurvePoint;
use crate::continuation::{
    self, Branch, Failure, Kind, Lost, Monitor, Point, Reader, Settings, Walked,
};
use crate::field::Work;
use crate::flow::FlowError;
use crate::shooting::{Orbit, OrbitProblem, Shot, Solution, problem};

/// A multiplier this far off has left the condition.
const OFF: f64 = 1e-3;

/// A curve that has been followed, and what it cost.
pub type Curve<P> = (Walked<P, FlowError>, Work);

/// Follows the bifurcation `kind` that `orbit` meets at (p, q = settings.from) up to q = `settings.to`,
/// as long as p stays inside `window`; `watch` sees each point as it is found, and may end the curve there. `None` if there is no
/// condition for that kind.
///
/// # Errors
/// The first point cannot be converged on.
pub fn follow(
    plane: &Plane,
    kind: Kind,
    orbit: &Orbit,
    window: [f64; 2],
    settings: Settings,
    watch: &mut dyn FnMut(&CurvePoint<Orbit>) -> ControlFlow<()>,
) -> Result<Option<Curve<CurvePoint<Orbit>>>, Failure<FlowError>> {
    let Some(condition) = Condition::of_orbits(kind) else {
        return Ok(None);
    };
    let guess = orbit.guess();
    let (p, q) = (orbit.r, settings.from);
    let family = plane.along_p(q).with_magnitude(&guess.magnitude);
    let (mut orbit_problem, z) = problem(family, p, &guess, 1).map_err(Failure::Evaluation)?;
    orbit_problem
        .float(&guess.place, p)
        .map_err(Failure::Evaluation)?;
    let plane = Plane {
        family: plane.family.with_magnitude(&guess.magnitude),
        designs: plane.designs,
    };
    let scales = [
        (window[1] - window[0]).abs(),
        (settings.to - settings.from).abs(),
    ];
    let unfolding = Unfolding {
        plane: plane.clone(),
        scales,
    };
    let mut problem = CriticalProblem::new(plane, orbit_problem, condition, scales);
    let z = joined(&z, p);
    problem.align(&z, q).map_err(Failure::Evaluation)?;
    let started = Branch::start(problem, z, settings)?;
    let reader = Orbits {
        kind,
        window,
        unfolding,
        accuracy: settings.accuracy,
    };
    Ok(Some(continuation::follow(reader, started, settings, watch)))
}

/// Reads critical orbits off their unknowns.
#[derive(Clone)]
struct Orbits {
    kind: Kind,
    window: [f64; 2],
    unfolding: Unfolding,
    accuracy: f64,
}

impl Reader for Orbits {
    type Problem = CriticalProblem<OrbitProblem>;
    type Point = CurvePoint<Orbit>;

    fn read(
        &self,
        problem: &CriticalProblem<OrbitProblem>,
        point: &Point<Critical<Shot>>,
        _work: Work,
    ) -> CurvePoint<Orbit> {
        let (z, p) = split(&point.z);
        let family = problem.plane.along_p(point.r);
        let solution = Solution {
            shot: &point.extra.of,
            z: &z,
            r: p,
            residual: point.residual,
        };
        let orbit = Orbit::read(&family, solution, self.accuracy, Work::default());
        let order = orbit.place.state.len();
        CurvePoint {
            p,
            q: point.r,
            q_scale: point.r_scale,
            of: orbit,
            test: point.extra.test,
            tangent: [point.tangent[order + 1], point.tangent[order + 2]],
            still: None,
        }
    }

    fn monitors(&self) -> Vec<Monitor<'_, CurvePoint<Orbit>>> {
        let bounds = bounds(self.window, |point: &CurvePoint<Orbit>| point.p);
        bounds.chain(monitors(self.kind, &self.unfolding)).collect()
    }

    /// Whether the multipliers do not say what the condition does any more.
    fn lost(&self, point: &CurvePoint<Orbit>) -> Option<Lost> {
        let off = Condition::of_orbits(self.kind)?.distance(&point.floquet().multipliers);
        (off.is_nan() || off > OFF).then_some(Lost::Off(off))
    }

    fn work(problem: &CriticalProblem<OrbitProblem>) -> Work {
        problem.subject.work
    }
}
