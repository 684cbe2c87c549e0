//! A branch of periodic orbits along the design variable.

use nalgebra::DVector;

use super::at_once::changes_at_once;
use super::begin::{SHARPER, begin};
use super::border::{between, cross, name};
use super::bound::unbounded;
use super::homoclinic::homoclinic;
use super::orbit::{Orbit, Solution};
use super::problem::OrbitProblem;
use super::rest::{comes_to_rest, rests_beyond};
use super::same::SAME_ORBIT;
use super::shot::Shot;
use super::shrunk::shrunk;
use super::slip::lets_go;
use super::sought::Search;
use super::stray::walks_back;
use super::symmetry::{SURE, lost_between, refine};
use super::vertical::stands_still;
use crate::bifurcation::{Kind, explain, falls, monitors};
use crate::continuation::{
    Beyond, Border, Branch, Crossing, Ending, Failure, Located, Monitor, Point, Reader, Reading,
    Settings, Started, Watched, ZeroProblem,
};
use crate::field::Work;
use crate::flow::FlowError;
use crate::integrate::Tolerance;
use crate::motion::Family;

/// A branch whose period has grown this many times has none in the end.
const ENDLESS: f64 = 1e6;
/// How far the halves of an orbit that has a symmetry may be apart for its errors, over the accuracy.
const ERRORS: f64 = 10.0;

/// Periodic orbits along r; an iterator over them.
pub type OrbitBranch = Reading<Orbits>;

/// Reads periodic orbits off their unknowns.
#[derive(Debug, Clone)]
pub struct Orbits {
    /// Number of states.
    order: usize,
    /// Relative accuracy of an orbit.
    accuracy: f64,
}

impl OrbitBranch {
    /// Starts from an orbit found at r = `settings.from`; the first item is that orbit.
    ///
    /// # Errors
    /// The orbit cannot be converged on with the family's derivative ∂/∂r.
    pub fn start(
        family: &Family,
        orbit: &Orbit,
        search: &Search,
        settings: Settings,
    ) -> Result<Self, Failure<FlowError>> {
        let upwards = settings.to >= settings.from;
        Self::start_at(family, orbit, search, settings, (settings.from, upwards))
    }

    /// Starts from an orbit found at r, anywhere in the range of the settings, and goes up from there or
    /// down; the first item is that orbit.
    ///
    /// # Errors
    /// The orbit cannot be converged on with the family's derivative ∂/∂r.
    pub fn start_at(
        family: &Family,
        orbit: &Orbit,
        search: &Search,
        settings: Settings,
        (r, upwards): (f64, bool),
    ) -> Result<Self, Failure<FlowError>> {
        let started = begin(family, orbit, search, settings, (r, upwards))?;
        Ok(Self::begin(started, search.accuracy))
    }

    /// The orbits of a branch of which the first point has been found.
    pub(super) fn begin(started: Started<OrbitProblem>, accuracy: f64) -> Self {
        let order = started.0.problem.magnitude.len();
        Self::new(Orbits { order, accuracy }, started, accuracy)
    }
}

impl Reader for Orbits {
    type Problem = OrbitProblem;
    type Point = Orbit;

    const TURNS_AT_FOLDS: bool = true;
    const CLOSES: bool = true;
    const ENDS_ON_POINTS: bool = false;

    fn read(&self, problem: &OrbitProblem, point: &Point<Shot>, work: Work) -> Orbit {
        let solution = Solution {
            shot: &point.extra,
            z: &point.z,
            r: point.r,
            residual: point.residual,
        };
        let mut orbit = Orbit::read(&problem.family, solution, self.accuracy, work);
        orbit.heading.follow(&point.tangent, point.r_scale);
        let known = orbit.heading.tangent.is_some();
        orbit.heading.way = known.then(|| point.way(&problem.scale()));
        orbit
    }

    fn between(&self, problem: &OrbitProblem, point: &Point<Shot>, chord: &DVector<f64>) -> Orbit {
        let mut orbit = self.read(problem, point, Work::default());
        // At a branch point the kernel has no one direction; that of the step is good enough for all.
        let slope = orbit.heading.slope;
        orbit.heading.follow(chord, point.r_scale);
        orbit.heading.slope = slope;
        orbit
    }

    /// Multipliers lose digits that the orbit keeps.
    const SHARPER: f64 = SHARPER;

    fn sharpen(&self, problem: &mut OrbitProblem, share: f64) {
        let tolerance = Tolerance::for_accuracy(share * self.accuracy);
        problem.family = problem.family.with_tolerance(tolerance);
    }

    fn monitors(&self) -> Vec<Monitor<'_, Orbit>> {
        monitors(self.order, self.accuracy)
    }

    /// A shorter orbit, gone around several times: the step went past where the branch meets that of the shorter one. Or one
    /// of those that it came by before it turned, or one that has lost a symmetry at a border, from which those that keep it go on
    /// as well.
    fn strays(&self, problem: &OrbitProblem, orbits: &[Orbit], orbit: &Orbit) -> bool {
        let family = &problem.family;
        let errors = ERRORS * self.accuracy;
        let lost =
            |last: &Orbit| !orbit.seems_in_regime_of(last) && orbit.has_lost(family, last, errors);
        let back = || walks_back(family, orbits, orbit, self.accuracy);
        orbit.repeats(SAME_ORBIT) || orbits.last().is_some_and(lost) || back()
    }

    /// Orbits without the symmetry that those before have, beyond where others lose it.
    fn leaves(&self, problem: &OrbitProblem, found: &Located<Orbit>, ends: [&Orbit; 2]) -> bool {
        let family = &problem.family;
        let lost = match found.kind {
            Kind::SymmetryBreaking => found.point.lost_symmetry(family).ok().flatten(),
            _ => None,
        };
        lost.is_some_and(|lost| {
            let [before, beyond] = ends.map(|orbit| orbit.keeps(family, &lost, SURE));
            before == Some(true) && beyond == Some(false)
        })
    }

    fn refine(&self, problem: &OrbitProblem, found: &mut Located<Orbit>) {
        if matches!(found.kind, Kind::BranchPoint | Kind::Fold) {
            refine(&problem.family, found, self.accuracy);
        }
    }

    fn lost_between(&self, problem: &OrbitProblem, ends: [&Orbit; 2]) -> Option<(Orbit, [f64; 2])> {
        lost_between(&problem.family, ends, self.accuracy)
    }

    fn cross(
        &self,
        branch: &Branch<OrbitProblem>,
        orbits: &[Orbit],
    ) -> Option<Crossing<OrbitProblem, Orbit>> {
        let Some(crossing) = cross(branch, orbits, self.accuracy) else {
            return changes_at_once(branch, orbits, self.accuracy);
        };
        if !matches!(crossing.beyond, Beyond::Undecided) {
            return Some(crossing);
        }
        let at = (crossing.located.r, crossing.located.error);
        let held = rests_beyond(branch, orbits, at, self.accuracy);
        Some(held.unwrap_or(crossing))
    }

    fn leads(
        &self,
        branch: &Branch<OrbitProblem>,
        orbits: &[Orbit],
    ) -> Option<Crossing<OrbitProblem, Orbit>> {
        comes_to_rest(branch, orbits, self.accuracy)
    }

    fn border(
        &self,
        problem: &mut OrbitProblem,
        ends: [&Orbit; 2],
        r_scale: f64,
    ) -> Option<Border<Orbit>> {
        between(problem, ends, r_scale, self.accuracy)
    }

    fn name(&self, problem: &OrbitProblem, ends: [&Orbit; 2]) -> Kind {
        name(&problem.family, ends).unwrap_or(Kind::VanishingSegment)
    }

    fn explain(&self, orbits: &[Orbit]) -> Option<Located<Orbit>> {
        explain(orbits, self.accuracy)
    }

    fn falls(&self, orbits: &[Orbit]) -> Option<Located<Orbit>> {
        falls(orbits, self.accuracy)
    }

    fn refused(
        &self,
        branch: &Branch<OrbitProblem>,
        orbits: &[Orbit],
        why: &FlowError,
    ) -> Option<Crossing<OrbitProblem, Orbit>> {
        match why {
            FlowError::Vanished { .. } => Some(Crossing {
                located: shrunk(&branch.problem.family, orbits)?,
                beyond: Beyond::Nothing,
            }),
            FlowError::LetsGo => lets_go(branch, orbits, self.accuracy)
                .or_else(|| comes_to_rest(branch, orbits, self.accuracy)),
            _ => None,
        }
    }

    fn ends(&self, branch: &Branch<OrbitProblem>, orbits: &[Orbit]) -> Option<Ending<FlowError>> {
        let [first, .., last] = orbits else {
            return None;
        };
        let endless = last.period > ENDLESS * first.period;
        let settings = branch.settings();
        let range = [settings.from, settings.to];
        let unbounded = || unbounded(orbits, range).map(Ending::Unbounded);
        endless
            .then_some(Ending::Endless(ENDLESS))
            .or_else(unbounded)
            .or_else(|| stands_still(orbits, self.accuracy).map(Ending::Family))
            .or_else(|| homoclinic(&branch.problem.family, orbits).map(Ending::Homoclinic))
    }

    fn closes(&self, first: &Orbit, back: &Orbit) -> bool {
        first.coincides(back, SAME_ORBIT)
    }

    fn work(problem: &OrbitProblem) -> Work {
        problem.work
    }
}
