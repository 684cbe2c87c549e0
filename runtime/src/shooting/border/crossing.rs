//! The orbits beyond a border: none where the motion jumps, else those that its normal form predicts.

use nalgebra::DVector;

use super::around::borders;
use super::candidate::Border as Candidate;
use super::hit::Met;
use super::located::{Edge, edge};
use super::nears::comes_there;
use crate::bifurcation::test_function::{flip, fold};
use crate::continuation::{
    Beyond, Branch, Crossing, Failure, Located, Started, Watched, ZeroProblem, changes,
};
use crate::field::Work;
use crate::flow::{EventKind, FlowError, Want};
use crate::motion::{Event, Place};
use crate::shooting::anchor::problem;
use crate::shooting::guess::Guess;
use crate::shooting::orbit::{Orbit, Solution};
use crate::shooting::phase::normal;
use crate::shooting::problem::OrbitProblem;
use crate::shooting::same::SAME_ORBIT;
use crate::shooting::stray::walks_back;

/// Distances from the border, in scaled coordinates, at which the branch is taken up again.
const DISTANCES: [f64; 7] = [3e-3, 1e-3, 1e-2, 1e-4, 3e-2, 1e-5, 1e-6];
/// Shares of the depth behind a wall that belongs to the speed of an impact, at which orbits that are hit are sought as well.
const DEPTHS: [f64; 5] = [1.0, 3.0, 10.0, 0.3, 30.0];
/// A first orbit this many times farther away lies on another branch, unless those nearer to it come to the border as they
/// come nearer, up to this factor.
const FAR: f64 = 5.0;
const COMES: f64 = 2.0;
/// Errors in r of orbits that have come to a border, over their accuracy.
pub(super) const NOISE: f64 = 100.0;
/// Change of the extents and of the period up to which a border is met, however r turns before it.
pub(super) const CLOSE: f64 = 1e-3;
/// Change of the extents and of the period, relative to themselves, over which a border is one that a branch comes to.
const REACH: f64 = 0.2;

/// What lies beyond the border that a branch comes to after its last point; `None` if it comes to none.
pub(in crate::shooting) fn cross(
    branch: &Branch<OrbitProblem>,
    orbits: &[Orbit],
    accuracy: f64,
) -> Option<Crossing<OrbitProblem, Orbit>> {
    let last = orbits.last()?;
    let mut work = Work::default();
    let family = &branch.problem.family;
    let scale = branch.problem.scale();
    let ahead = |found: &Edge| {
        let slope = towards(found, &branch.problem, &scale, branch.r_scale());
        let way = found.orbit.r - last.r;
        // So near to it an orbit may lie beyond for its errors.
        let level = way.abs() <= NOISE * accuracy * last.r_size();
        let one = last.away(&found.orbit) <= NOISE * accuracy.max(last.error_estimate);
        let apart = last.apart(&found.orbit);
        // As the branch leads to it, so it leads on from the last orbit.
        let ahead = slope.is_some_and(|slope| slope * way > 0.0) && last.heading.slope * way > 0.0;
        let met = apart <= CLOSE && comes_near(orbits, &found.orbit);
        let comes = met || one || apart <= REACH && (level || ahead);
        // One that is gone around twice is a border of the orbit that this one doubles: the branch meets that first.
        let own = found.orbit.halves() > SAME_ORBIT;
        let comes = comes && own && !walks_back(family, orbits, &found.orbit, accuracy);
        comes && (!found.jumps() || comes_there(family, last, &found.orbit, accuracy))
    };
    let found = edge(family, last, accuracy, &mut work, (|_: &_| true, ahead))?;
    let mut located = Located::at(found.kind, found.orbit.r, found.orbit.clone());
    located.error = found.error;
    let beyond = if found.ends() {
        Beyond::Nothing
    } else {
        onwards(&found, branch, last, work)
    };
    Some(Crossing { located, beyond })
}

/// Whether the last orbit is nearer to another one than those were from which the branch came: of those before a border it says
/// nothing that it comes from there.
fn comes_near(orbits: &[Orbit], to: &Orbit) -> bool {
    let Some((last, before)) = orbits.split_last() else {
        return false;
    };
    let away = last.away(to);
    let far = |orbit: &&Orbit| orbit.away(last) > away;
    let here = before.iter().rev();
    let mut here = here.take_while(|orbit| orbit.has_word_of(last, 1));
    let earlier = here.find(far);
    earlier.is_some_and(|earlier| earlier.away(to) > away)
}

/// How r changes on the way to the border, on the side from which it is come to.
fn towards(
    found: &Edge,
    problem: &OrbitProblem,
    scale: &DVector<f64>,
    r_scale: f64,
) -> Option<f64> {
    let phase = phase(problem, found);
    let away = found
        .sides
        .direction(found.border.happens, &phase, scale, r_scale)?;
    Some(-away[away.len() - 1])
}

/// The direction along which the start of shooting is fixed, as its phase condition has it.
pub(super) fn phase(problem: &OrbitProblem, found: &Edge) -> DVector<f64> {
    let velocity = &found.sides.velocity;
    match problem.family.phase() {
        Some(drive) => DVector::from_fn(velocity.len(), |j, _| f64::from(j == drive)),
        None => normal(velocity, &problem.magnitude),
    }
}

/// The branch on the other side, from the first distance at which it is found and nothing is passed.
fn onwards(
    found: &Edge,
    branch: &Branch<OrbitProblem>,
    last: &Orbit,
    mut work: Work,
) -> Beyond<OrbitProblem> {
    let (scale, r_scale) = (branch.problem.scale(), branch.r_scale());
    let (sides, other) = (&found.sides, !found.border.happens);
    let phase = phase(&branch.problem, found);
    let Some(direction) = sides.direction(other, &phase, &scale, r_scale) else {
        return Beyond::Undecided;
    };
    let hit = other.then(|| sides.hit(&phase, &scale, r_scale)).flatten();
    let guesses = |distance: f64| -> Vec<(f64, DVector<f64>)> {
        let Some(hit) = &hit else {
            return vec![(distance, &direction * distance)];
        };
        let aimed = hit.guess(distance, |offset| met(found, branch, offset));
        let others = DEPTHS.map(|share| hit.behind(distance, share));
        let all = std::iter::once(aimed).chain(others);
        all.map(|offset| (distance, offset)).collect()
    };
    let mut nearest = (f64::INFINITY, Beyond::Undecided);
    let mut seen: Vec<[f64; 2]> = Vec::new();
    for (distance, offset) in DISTANCES.into_iter().flat_map(guesses) {
        if distance > nearest.0 {
            continue;
        }
        let Ok(started) = set_out(found, branch, &direction, &offset, work) else {
            continue;
        };
        work = started.0.problem.work;
        let first = first(&started, last.error_estimate);
        let apart = found.orbit.apart(&first);
        let comes =
            |one: &[f64; 2]| one[0] > distance && apart <= COMES * one[1] * distance / one[0];
        let near = apart <= FAR * distance || apart <= CLOSE && seen.iter().any(comes);
        seen.push([distance, apart]);
        if !near || first.has_word_of(last, 1) {
            continue;
        }
        nearest = (distance, Beyond::Onwards(Box::new(started)));
        let leaves = direction[direction.len() - 1];
        let passes = || passes(found, last, (&first, leaves));
        let leaps = match hit {
            Some(_) => turns(&first, leaves),
            None => passes() || skips(found, branch, last, &first),
        };
        if !leaps {
            break;
        }
    }
    nearest.1
}

/// Whether a bifurcation may lie between the border and the first orbit beyond it, as far as multipliers tell, or the way in
/// which r goes on: nobody would look for it there. A fold and a flip may leave as many directions unstable as before.
fn passes(found: &Edge, last: &Orbit, (first, leaves): (&Orbit, f64)) -> bool {
    if found.border.drops {
        return false;
    }
    let beyond = found.seen_from(last, !found.border.happens, leaves);
    let both = [&beyond, first];
    let certain = both.map(|orbit| orbit.floquet.growths.marginal() == 0);
    let [at, next] = both.map(|orbit| {
        let multipliers = &orbit.floquet.multipliers;
        [orbit.heading.slope, fold(multipliers), flip(multipliers)]
    });
    certain != [true; 2]
        || beyond.floquet.unstable != first.floquet.unstable
        || at.into_iter().zip(next).any(|(at, next)| changes(at, next))
}

/// Whether the same holds of an orbit that is hit: one multiplier is unbounded at the border there.
fn turns(first: &Orbit, leaves: f64) -> bool {
    first.floquet.unstable == 0 || changes(leaves, first.heading.slope)
}

/// Whether another border may lie between this one and the first orbit beyond it: what is short on one side of this one is
/// not all that their words differ by. Nobody would look for it there.
fn skips(found: &Edge, branch: &Branch<OrbitProblem>, last: &Orbit, first: &Orbit) -> bool {
    let border = &found.border;
    if border.is_brief() {
        return !border.parts(last, first);
    }
    let flow = branch.problem.family.at(first.r);
    let Ok(near) = flow.and_then(|flow| borders(flow.as_ref(), first)) else {
        return true;
    };
    let same = |one: &&Candidate| {
        one.is_brief() && (one.contact, one.condition) == (border.contact, border.condition)
    };
    !near.iter().filter(same).any(|one| one.parts(first, last))
}

/// How the motion that begins so far from the border meets the wall: at the slowest of its impacts, if any is.
fn met(found: &Edge, branch: &Branch<OrbitProblem>, offset: &DVector<f64>) -> Option<Met> {
    let (start, orbit) = (&found.sides.start, &found.orbit);
    let scale = branch.problem.scale();
    let moved = |(j, x): (usize, &f64)| x + offset[j] * scale[j];
    let place = Place {
        state: start.state.iter().enumerate().map(moved).collect(),
        modes: start.modes.clone(),
    };
    let r = orbit.r + offset[offset.len() - 1] * branch.r_scale();
    let flow = branch.problem.family.at(r).ok()?;
    let passage = flow.advance(&place, orbit.period, Want::EXTREMA).ok()?;
    let own = passage
        .events
        .iter()
        .filter(|event| event.contact == found.border.contact);
    let speed = |event: &Event| match event.kind {
        EventKind::Impact { approach, .. } => Some(approach),
        _ => None,
    };
    let gap = |event: &Event| match event.kind {
        EventKind::Nearest { margin } => Some(margin),
        _ => None,
    };
    let slowest = own.clone().filter_map(speed).reduce(f64::min);
    let least = own.filter_map(gap).reduce(f64::min);
    slowest.map(Met::Hit).or(least.map(Met::Missed))
}

fn first((branch, point): &Started<OrbitProblem>, accuracy: f64) -> Orbit {
    let solution = Solution {
        shot: &point.extra,
        z: &point.z,
        r: point.r,
        residual: point.residual,
    };
    let mut orbit = Orbit::read(&branch.problem.family, solution, accuracy, Work::default());
    orbit.heading.follow(&point.tangent, point.r_scale);
    orbit
}

fn set_out(
    found: &Edge,
    branch: &Branch<OrbitProblem>,
    direction: &DVector<f64>,
    offset: &DVector<f64>,
    work: Work,
) -> Result<Started<OrbitProblem>, Failure<FlowError>> {
    let (sides, orbit) = (&found.sides, &found.orbit);
    let guess = Guess {
        place: sides.start.clone(),
        period: orbit.period,
        magnitude: branch.problem.magnitude.clone(),
        pins: sides.runs.pins.clone(),
        shift: sides.runs.shift.clone(),
        division: None,
    };
    let family = branch.problem.family.clone();
    let (mut problem, z) = problem(family, orbit.r, &guess, 1).map_err(Failure::Evaluation)?;
    let floated = problem.float(&sides.start, orbit.r);
    floated.map_err(Failure::Evaluation)?;
    (problem.work, problem.accuracy) = (work, branch.problem.accuracy);
    let (n, scale, r_scale) = (z.len(), problem.scale(), branch.r_scale());
    let moved = &z + offset.rows(0, n).component_mul(&scale);
    let r = orbit.r + offset[n] * r_scale;
    Branch::set_out(problem, (moved, r), (direction, r_scale), branch.settings())
}
