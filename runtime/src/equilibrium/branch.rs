//! A branch of equilibria along the design variable, with everything that happens on it.

use std::ops::ControlFlow;

use nalgebra::DVector;

use super::EquilibriumProblem;
use super::locate::{Locator, spot};
use super::special::{Found, Kind, Spot};
use crate::continuation::{self, Ending, Failure, Settings};
use crate::field::Work;
use crate::flow::FlowError;
use crate::motion::{Family, Modes, Place, Velocity};

/// A branch that has been followed.
#[derive(Debug, Clone)]
pub struct Branch {
    /// Its points in the order in which they were found.
    pub points: Vec<Spot>,
    /// What happens on it, in the same order.
    pub special: Vec<Found>,
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
pub fn follow(
    family: &Family,
    from: &Place,
    settings: Settings,
    watch: &mut dyn FnMut(&Spot) -> ControlFlow<()>,
) -> Result<Branch, Failure<FlowError>> {
    let problem = EquilibriumProblem::new(family.clone(), from.modes.clone(), &from.state);
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
struct Walk {
    r_scale: f64,
    accuracy: f64,
    points: Vec<Spot>,
    special: Vec<Found>,
}

impl Walk {
    /// Takes in the next point; `Some` if the branch ends with it.
    fn on(
        &mut self,
        problem: &mut EquilibriumProblem,
        point: &continuation::Point<Velocity>,
    ) -> Option<End> {
        let continuation::Point { z, r, extra, .. } = point;
        let tangent_r = point.tangent[z.len()];
        let mut here = spot(problem, z, *r, extra, tangent_r, point.residual)?;
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

impl Spot {
    /// The place of this point in these modes.
    #[must_use]
    pub fn place(&self, modes: Modes) -> Place {
        Place {
            state: self.state.clone(),
            modes,
        }
    }
}
