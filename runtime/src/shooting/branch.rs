//! A branch of periodic orbits along the design variable.

use super::guess::Guess;
use super::orbit::{Orbit, Solution};
use super::problem::{OrbitProblem, Shot};
use super::search::{Search, problem};
use crate::bifurcation::Path;
use crate::continuation::{Branch, Ending, Failure, Link, Point, Settings};
use crate::field::Work;
use crate::flow::{Family, Flow, FlowError};
use crate::integrate::Tolerance;

type Mode<F, const N: usize> = <<F as Family<N>>::Flow as Flow<N>>::Mode;

/// Share of the accuracy to which orbits between two others are integrated.
const SHARPER: f64 = 0.02;

/// Periodic orbits along r; an iterator over them.
pub struct OrbitBranch<F: Family<N> + Clone, const N: usize> {
    branch: Branch<OrbitProblem<F, N>>,
    first: Option<Orbit<N, Mode<F, N>>>,
    accuracy: f64,
    counted: Work,
}

impl<F: Family<N> + Clone, const N: usize> OrbitBranch<F, N> {
    /// Starts from an orbit found at r = `settings.from`; the first item is that orbit.
    ///
    /// # Errors
    /// The orbit cannot be converged on with the family's derivative ∂/∂r.
    pub fn start(
        family: &F,
        orbit: &Orbit<N, Mode<F, N>>,
        search: &Search<N>,
        settings: Settings,
    ) -> Result<Self, Failure<FlowError>> {
        let magnitude = std::array::from_fn(|j| 0.5 * (orbit.max[j] - orbit.min[j]));
        let family = family
            .with_tolerance(Tolerance::for_accuracy(search.accuracy))
            .with_magnitude(magnitude);
        let guess = Guess {
            place: orbit.place,
            period: orbit.period,
            magnitude,
        };
        let (mut problem, z) =
            problem(family, settings.from, &guess, search.segments).map_err(Failure::Evaluation)?;
        problem
            .float(&orbit.place, settings.from)
            .map_err(Failure::Evaluation)?;
        let (branch, first) = Branch::start(problem, z, settings)?;
        let mut orbits = Self {
            branch,
            first: None,
            accuracy: search.accuracy,
            counted: Work::default(),
        };
        let first = orbits.read(&first);
        orbits.first = Some(first);
        Ok(orbits)
    }

    /// Why the branch ended; `None` while it goes on.
    #[must_use]
    pub fn ending(&self) -> Option<&Ending<FlowError>> {
        self.branch.ending()
    }

    /// What lies between the last two orbits; `None` at the first.
    #[must_use]
    pub fn path(&self) -> Option<OrbitPath<F, N>> {
        let mut link = self.branch.link()?.clone();
        // Multipliers lose digits that the orbit keeps.
        let tolerance = Tolerance::for_accuracy(SHARPER * self.accuracy);
        link.problem.family = link.problem.family.with_tolerance(tolerance);
        let counted = link.problem.work;
        Some(OrbitPath {
            link,
            accuracy: self.accuracy,
            counted,
        })
    }

    fn read(&mut self, point: &Point<Shot<N, Mode<F, N>>>) -> Orbit<N, Mode<F, N>> {
        let total = self.branch.problem.work;
        let work = total.since(&self.counted);
        self.counted = total;
        read(&self.branch.problem.family, point, self.accuracy, work)
    }
}

fn read<F: Family<N>, const N: usize>(
    family: &F,
    point: &Point<Shot<N, Mode<F, N>>>,
    accuracy: f64,
    work: Work,
) -> Orbit<N, Mode<F, N>> {
    let solution = Solution {
        shot: &point.extra,
        z: &point.z,
        r: point.r,
        residual: point.residual,
    };
    let mut orbit = Orbit::read(family, solution, accuracy, work);
    orbit.slope = point.tangent_r;
    orbit
}

/// The orbits between two neighbouring ones of a branch.
pub struct OrbitPath<F: Family<N>, const N: usize> {
    link: Link<OrbitProblem<F, N>>,
    accuracy: f64,
    counted: Work,
}

impl<F: Family<N> + Clone, const N: usize> OrbitPath<F, N> {
    /// Work of all orbits found on it.
    #[must_use]
    pub fn work(&self) -> Work {
        self.link.problem.work.since(&self.counted)
    }
}

impl<F: Family<N> + Clone, const N: usize> Path for OrbitPath<F, N> {
    type Point = Orbit<N, Mode<F, N>>;
    type Error = Failure<FlowError>;

    fn at(&mut self, share: f64) -> Result<Self::Point, Self::Error> {
        let point = self.link.between(share)?;
        let family = &self.link.problem.family;
        Ok(read(family, &point, self.accuracy, Work::default()))
    }
}

impl<F: Family<N> + Clone, const N: usize> Iterator for OrbitBranch<F, N> {
    type Item = Orbit<N, Mode<F, N>>;

    fn next(&mut self) -> Option<Self::Item> {
        if let Some(first) = self.first.take() {
            return Some(first);
        }
        let point = self.branch.next()?;
        Some(self.read(&point))
    }
}
