//! From one branch of orbits onto another that crosses it: at flips and at branch points.

use nalgebra::DVector;

use super::branch::OrbitBranch;
use super::division::Division;
use super::orbit::Orbit;
use super::problem::OrbitProblem;
use super::sought::Search;
use crate::bifurcation::Stability;
use crate::continuation::{Branch, Failure, Kind, Located, Settings, ZeroProblem, across, tangent};
use crate::flow::FlowError;
use crate::integrate::Tolerance;
use crate::motion::{Family, Place};

/// Distances from the crossing, in scaled coordinates, at which the other branch is sought.
const DISTANCES: [f64; 6] = [1e-2, 3e-3, 3e-2, 1e-3, 1e-1, 1e-4];
/// A point this many times farther away lies on a branch that does not come from the crossing.
const FAR: f64 = 20.0;
/// Other places of an orbit at which it is begun where that fails.
const OTHERS: usize = 2;
/// Share of the distance by which a doubled orbit must miss closing after half its period.
const OPEN: f64 = 0.05;

/// Why no other branch sets out from a special point.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SwitchError {
    /// The orbit was found off any branch, or over several segments.
    #[error("the direction of its branch is not known there")]
    NoHeading,
    /// No point of another branch was found.
    #[error("no point of another branch was found beside it")]
    NotFound,
    /// The corrector failed at all distances; the last reason.
    #[error("no point of another branch was found beside it: {0}")]
    Newton(#[from] Failure<FlowError>),
}

/// A special point at which another branch is sought.
type Crossing = Located<Orbit>;

/// Which branch is wanted.
#[derive(Clone, Copy)]
struct Turn {
    /// How many times the orbit is gone around: 2 at a flip, 1 at a branch point.
    times: u8,
    /// On which side of the crossing the branch sets out: at a flip both are the same.
    forwards: bool,
}

impl OrbitBranch {
    /// The branch that crosses the one on which `crossing` was located, on either side of it: at a flip, where orbits of
    /// twice the period leave, both sides are the same.
    ///
    /// # Errors
    /// See [`SwitchError`].
    pub fn switch(
        family: &Family,
        crossing: &Crossing,
        forwards: bool,
        search: &Search,
        settings: Settings,
    ) -> Result<Self, SwitchError> {
        let times = if crossing.kind == Kind::Flip { 2 } else { 1 };
        let (turn, orbit) = (Turn { times, forwards }, &crossing.point);
        let along = orbit.heading.tangent.as_ref();
        let along = along.ok_or(SwitchError::NoHeading)?;
        let start = &orbit.heading.start;
        let mut last = match Self::leave(family, (crossing, start), along, turn, search, settings) {
            Ok(branch) => return Ok(branch),
            Err(error) => error,
        };
        if turn.times == 1 {
            return Err(last);
        }
        // At a flip, the branch of the orbit itself has but one tangent, wherever the orbit begins.
        let flow = family.at(orbit.r).map_err(Failure::Evaluation)?;
        for state in orbit.section.iter().take(OTHERS) {
            let Ok(start) = flow.place(state) else {
                continue;
            };
            let once = Turn { times: 1, ..turn };
            let Ok(along) = heading(family, (orbit, &start), once, search) else {
                continue;
            };
            match Self::leave(family, (crossing, &start), &along, turn, search, settings) {
                Ok(branch) => return Ok(branch),
                Err(error) => last = error,
            }
        }
        Err(last)
    }

    fn leave(
        family: &Family,
        (crossing, start): (&Crossing, &Place),
        along: &DVector<f64>,
        turn: Turn,
        search: &Search,
        settings: Settings,
    ) -> Result<Self, SwitchError> {
        let orbit = &crossing.point;
        let problem = gone_around(family, (orbit, start), turn, search)?;
        let period = f64::from(turn.times) * orbit.period;
        let z = OrbitProblem::unknowns(std::slice::from_ref(start), period);
        let linearisation = problem.clone().evaluate(&z, orbit.r);
        let linearisation = linearisation.map_err(Failure::Evaluation)?;
        let (scale, r_scale) = (problem.scale(), orbit.heading.r_scale);
        let side = if turn.forwards { 1.0 } else { -1.0 };
        let direction = across(&linearisation, &scale, r_scale, along);
        let direction = direction.ok_or(SwitchError::NotFound)? * side;
        let set_out = |distance: f64| {
            let moved = step((&z, orbit.r), &direction, distance, &scale, r_scale);
            let started = Branch::set_out(problem.clone(), moved, (&direction, r_scale), settings)?;
            let branch = Self::begin(started, search.accuracy);
            let first = branch.first();
            let leaves = first.is_some_and(|first| leaves(first, orbit, turn, distance, r_scale));
            leaves.then_some(branch).ok_or(SwitchError::NotFound)
        };
        let mut found = Err(SwitchError::NotFound);
        let mut nearest = f64::INFINITY;
        for distance in DISTANCES {
            if distance > nearest {
                continue;
            }
            match set_out(distance) {
                Ok(branch) => {
                    let passed = branch
                        .first()
                        .is_some_and(|first| passed(first, crossing, turn));
                    (found, nearest) = (Ok(branch), distance);
                    if !passed {
                        break;
                    }
                }
                Err(error) if found.is_err() => found = Err(error),
                Err(_) => {}
            }
        }
        found
    }
}

/// Whether a bifurcation lies between the crossing and the first orbit beside it, as far as its multipliers and its events
/// tell: nobody would look for it there.
fn passed(first: &Orbit, crossing: &Located<Orbit>, turn: Turn) -> bool {
    let expected = crossing.unstable_beside(first.r);
    let certain = first.floquet.stability != Stability::Undecided;
    let exchanged = !certain || expected.is_none_or(|count| count == first.floquet.unstable);
    !exchanged || !first.has_word_of(&crossing.point, usize::from(turn.times))
}

/// The tangent of the branch of the orbit, beginning at another place.
fn heading(
    family: &Family,
    at: (&Orbit, &Place),
    once: Turn,
    search: &Search,
) -> Result<DVector<f64>, SwitchError> {
    let mut problem = gone_around(family, at, once, search)?;
    let z = OrbitProblem::unknowns(std::slice::from_ref(at.1), at.0.period);
    let linearisation = problem.evaluate(&z, at.0.r).map_err(Failure::Evaluation)?;
    let r_scale = at.0.heading.r_scale;
    let mut upwards = DVector::zeros(z.len() + 1);
    upwards[z.len()] = 1.0;
    let found = tangent(&linearisation, &problem.scale(), r_scale, &upwards);
    found.ok_or(SwitchError::NotFound)
}

/// The shooting problem of the orbit gone around as often as the turn wants.
fn gone_around(
    family: &Family,
    (orbit, start): (&Orbit, &Place),
    turn: Turn,
    search: &Search,
) -> Result<OrbitProblem, SwitchError> {
    let magnitude = orbit.magnitude();
    let family = family
        .with_tolerance(Tolerance::for_accuracy(search.accuracy))
        .with_magnitude(&magnitude);
    let velocity = family.at(orbit.r).and_then(|flow| flow.velocity(start));
    let velocity = velocity.map_err(Failure::Evaluation)?.f;
    let phase = super::Phase::floating(family.phase(), start.state.clone(), &velocity, &magnitude);
    let period = f64::from(turn.times) * orbit.period;
    let whole = Division::whole(start.clone());
    Ok(OrbitProblem::new(family, phase, &whole, period, magnitude))
}

/// The point at this distance from (z, r).
fn step(
    (z, r): (&DVector<f64>, f64),
    direction: &DVector<f64>,
    distance: f64,
    scale: &DVector<f64>,
    r_scale: f64,
) -> (DVector<f64>, f64) {
    let n = z.len();
    let moved = z + direction.rows(0, n).component_mul(scale) * distance;
    (moved, r + direction[n] * r_scale * distance)
}

/// Whether a first point lies near the crossing, and not on the branch from which it was sought.
fn leaves(first: &Orbit, orbit: &Orbit, turn: Turn, distance: f64, r_scale: f64) -> bool {
    let times = f64::from(turn.times);
    let away = ((first.r - orbit.r) / r_scale)
        .abs()
        .max((first.period / (times * orbit.period) - 1.0).abs());
    let open = turn.times == 1 || first.halves() > OPEN * distance;
    away <= FAR * distance && open
}
