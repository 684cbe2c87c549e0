//! A branch of equilibria along the design variable.

use std::ops::ControlFlow;

use nalgebra::DVector;

use super::EquilibriumProblem;
use super::special::{EquilibriumPoint, monitors, turns};
use crate::continuation::{self, Failure, Monitor, Point, Reader, Settings, Walked, ZeroProblem};
use crate::field::Work;
use crate::flow::FlowError;
use crate::motion::{Family, Place, Velocity, sticking};

/// A branch that has been followed, and what it cost.
pub type Branch = (Walked<EquilibriumPoint, FlowError>, Work);

/// Follows the equilibrium at `from`; `watch` sees each point as it is found, and may end the branch there.
///
/// # Errors
/// There is no equilibrium to begin with.
pub fn follow(
    family: &Family,
    from: &Place,
    settings: Settings,
    watch: &mut dyn FnMut(&EquilibriumPoint) -> ControlFlow<()>,
) -> Result<Branch, Failure<FlowError>> {
    let problem = EquilibriumProblem::new(family.clone(), settings.from, from);
    let z = DVector::from_column_slice(&from.state);
    let neutral = sticking(&from.modes) + problem.kept.len();
    let order = from.state.len().saturating_sub(neutral);
    let started = continuation::Branch::start(problem, z, settings)?;
    Ok(continuation::follow(
        Equilibria { order },
        started,
        settings,
        watch,
    ))
}

/// How a branch of equilibria is followed: they cost so little that the steps may be short.
#[must_use]
pub fn settings(from: f64, to: f64) -> Settings {
    Settings {
        largest_step: 0.05,
        ..Settings::new(from, to, 1e-12)
    }
}

/// Reads equilibria off their unknowns.
#[derive(Clone)]
struct Equilibria {
    order: usize,
}

impl Reader for Equilibria {
    type Problem = EquilibriumProblem;
    type Point = EquilibriumPoint;

    fn read(
        &self,
        problem: &EquilibriumProblem,
        point: &Point<Velocity>,
        _work: Work,
    ) -> EquilibriumPoint {
        let (place, velocity) = (problem.place(&point.z), &point.extra);
        let flow = problem.family.at(point.r).ok();
        EquilibriumPoint {
            spectrum: problem.spectrum(flow.as_deref(), &place, velocity),
            residual: point.residual,
            margins: flow.map_or_else(Vec::new, |flow| flow.margins(&place)),
            state: place.state,
            r: point.r,
            way: point.way(&problem.scale()),
            r_scale: point.r_scale,
            slope: point.tangent[point.z.len()],
            determinant: problem.determinant(&point.z, point.r, velocity),
            critical: None,
        }
    }

    fn monitors(&self) -> Vec<Monitor<'_, EquilibriumPoint>> {
        monitors(self.order)
    }

    fn straight(&self, ends: [&EquilibriumPoint; 2]) -> bool {
        !turns(ends) && ends[0].r != ends[1].r
    }

    fn work(problem: &EquilibriumProblem) -> Work {
        problem.work
    }
}
