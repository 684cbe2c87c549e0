//! A branch of equilibria along the design variable, with everything that happens on it.

use std::ops::ControlFlow;

use nalgebra::DVector;

use super::locate::{Locator, spot};
use super::special::{Found, Kind, Spot};
use super::{Confined, EquilibriumProblem};
use crate::continuation::{self, Ending, Failure, Settings};
use crate::field::Work;
use crate::flow::{Family, Flow, FlowError, Place, Velocity};

type Mode<F, const N: usize> = <<F as Family<N>>::Flow as Flow<N>>::Mode;

/// A branch that has been followed.
#[derive(Debug, Clone)]
pub struct Branch<const N: usize> {
    /// Its points in the order in which they were found.
    pub points: Vec<Spot<N>>,
    /// What happens on it, in the same order.
    pub special: Vec<Found<N>>,
    /// Why it ended.
    pub end: End,
    /// What it cost.
    pub work: Work,
}

/// Why a branch of equilibria ended.
#[derive(Debug, Clone, PartialEq)]
pub enum End {
    /// As any branch does.
    Followed(Ending<FlowError>),
    /// This contact has no relative speed any more.
    Boundary(usize),
    /// Whoever watched wanted no more.
    Stopped,
    /// The stability changes between these values of r, and no bifurcation was found there.
    Unexplained(f64, f64),
}

/// Follows the equilibrium at `from`; `watch` sees each point as it is found, and may end the branch there.
///
/// # Errors
/// There is no equilibrium to begin with.
pub fn follow<F: Family<N> + Clone, const N: usize>(
    family: &F,
    from: &Place<N, Mode<F, N>>,
    settings: Settings,
    watch: &mut dyn FnMut(&Spot<N>) -> ControlFlow<()>,
) -> Result<Branch<N>, Failure<FlowError>>
where
    F::Flow: Confined<N>,
{
    let problem = EquilibriumProblem::new(family.clone(), from.mode, &from.state);
    let z = DVector::from_column_slice(&from.state);
    let (mut branch, first) = continuation::Branch::start(problem, z, settings)?;
    let mut walk = Walk {
        r_scale: (settings.to - settings.from).abs(),
        accuracy: settings.accuracy,
        points: Vec::new(),
        special: Vec::new(),
    };
    let mut next = Some(first);
    let mut end = None;
    while let (Some(point), None) = (next.take(), &end) {
        end = walk.on(&mut branch.problem, &point);
        let seen = walk.points.last().map(&mut *watch);
        if seen.is_some_and(|verdict| verdict.is_break()) {
            end.get_or_insert(End::Stopped);
        }
        if end.is_none() {
            next = branch.next();
        }
    }
    let ending = branch.ending().cloned().unwrap_or(Ending::TooManyPoints);
    Ok(Branch {
        points: walk.points,
        special: walk.special,
        end: end.unwrap_or(End::Followed(ending)),
        work: branch.problem.work,
    })
}

/// A branch on the way.
struct Walk<const N: usize> {
    r_scale: f64,
    accuracy: f64,
    points: Vec<Spot<N>>,
    special: Vec<Found<N>>,
}

impl<const N: usize> Walk<N> {
    /// Takes in the next point; `Some` if the branch ends with it.
    fn on<F: Family<N>>(
        &mut self,
        problem: &mut EquilibriumProblem<F, N>,
        point: &continuation::Point<Velocity<N>>,
    ) -> Option<End>
    where
        F::Flow: Confined<N>,
    {
        let continuation::Point { z, r, extra, .. } = point;
        let mut here = spot(problem, z, *r, extra, point.tangent[N], point.residual)?;
        let mut locator = Locator {
            problem,
            r_scale: self.r_scale,
            accuracy: self.accuracy,
        };
        let boundary = Kind::BoundaryEquilibrium;
        let beyond = here.test(boundary) <= 0.0;
        let mut end = None;
        if let Some(last) = self.points.last() {
            if beyond {
                here = locator.locate(last, &here, boundary);
            }
            match locator.events(last, &here) {
                Ok(found) => self.special.extend(found),
                Err((from, to)) => end = Some(End::Unexplained(from, to)),
            }
        }
        if beyond {
            let nearest = here.margins.iter().min_by(|a, b| a.1.total_cmp(&b.1));
            end = nearest.map(|(contact, _)| End::Boundary(*contact));
            self.special.push(Found {
                kind: boundary,
                spot: here.clone(),
            });
        }
        self.points.push(here);
        end
    }
}

/// How a branch of equilibria is followed: they cost so little that the steps may be short.
#[must_use]
pub fn settings(from: f64, to: f64) -> Settings {
    Settings {
        largest_step: 0.05,
        ..Settings::new(from, to, 1e-12)
    }
}

impl<const N: usize> Spot<N> {
    /// The place of this point in `mode`.
    pub fn place<Mode>(&self, mode: Mode) -> Place<N, Mode> {
        Place {
            state: self.state,
            mode,
        }
    }
}
