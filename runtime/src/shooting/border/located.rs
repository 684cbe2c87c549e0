//! The border near to which orbits are, found as a point of its own.

use nalgebra::DVector;

use super::around::borders;
use super::candidate::Border;
use super::centred::centred;
use super::problem::BorderProblem;
use super::sides::Sides;
use crate::bifurcation::{Disturbances, Kind, floquet};
use crate::continuation::{Failure, SETTLED, Watched, ZeroProblem, correct_at};
use crate::field::Work;
use crate::flow::{EventKind, FlowError};
use crate::integrate::Tolerance;
use crate::motion::{Event, Family, most_stuck};
use crate::shooting::orbit::{Orbit, Solution};
use crate::shooting::problem::OrbitProblem;
use crate::shooting::same::SAME_ORBIT;
use crate::shooting::shot::Shot;

/// Borders that are tried, the nearest first.
const TRIED: usize = 4;
/// Shares of the accuracy to which orbits on borders are integrated: the first at which they are found, and the finer one
/// with which their error is measured.
const SHARPER: [f64; 3] = [0.02, 0.002, 2e-4];
/// Residual, or correction, up to which errors of the integration may keep Newton's method from converging.
const NOISY: f64 = 1e-3;
/// Share of the period within which an impact is that of the grazing itself.
const AT_ONCE: f64 = 1e-6;
/// What is reported over what two runs differ by: they share part of their errors.
const DOUBT: f64 = 2.0;

/// An orbit on a border.
pub(in crate::shooting) struct Edge {
    /// Which bifurcation it is.
    pub(in crate::shooting) kind: Kind,
    /// The orbit, as it is come to on the side of the one from which it was found.
    pub(in crate::shooting) orbit: Orbit,
    /// The border itself.
    pub(super) border: Border,
    /// What its normal form says.
    pub(super) sides: Sides,
    /// Estimated error of r.
    pub(super) error: f64,
}

/// The first border near to `orbit`, of those that are `wanted`, that `fits`.
pub(in crate::shooting) fn edge(
    family: &Family,
    orbit: &Orbit,
    accuracy: f64,
    work: &mut Work,
    (wanted, fits): (impl Fn(&Border) -> bool, impl Fn(&Edge) -> bool),
) -> Option<Edge> {
    let flow = family.at(orbit.r).ok()?;
    let near = borders(flow.as_ref(), orbit).ok()?;
    near.into_iter()
        .filter(wanted)
        .take(TRIED)
        .find_map(|border| {
            let found = converge(family, orbit, border, accuracy, work)?;
            fits(&found).then_some(found)
        })
}

fn converge(
    family: &Family,
    orbit: &Orbit,
    border: Border,
    accuracy: f64,
    work: &mut Work,
) -> Option<Edge> {
    let scales = [orbit.r_size().max(f64::MIN_POSITIVE), 1.0];
    let sharpened = |share: f64| {
        family
            .with_tolerance(Tolerance::for_accuracy(share * accuracy))
            .with_magnitude(&orbit.magnitude())
    };
    let at =
        |border: Border, share: f64| BorderProblem::new(sharpened(share), orbit, border, scales);
    let [first, again, last] = SHARPER;
    let mut problem = at(border, first)?;
    let z = problem.unknowns(orbit.r);
    let mut loose = correct_at(&mut problem, z.clone(), 0.0, accuracy);
    *work += problem.work;
    let mut next = again;
    if loose.as_ref().is_err_and(is_noise) {
        problem = at(problem.border, again)?;
        loose = correct_at(&mut problem, z, 0.0, accuracy);
        *work += problem.work;
        next = last;
    }
    let loose = loose.ok()?;
    let shot = &loose.linearisation.extra;
    if !shot.least || (shot.period / orbit.period).ln().abs() > 1.0 {
        return None;
    }
    let (z, moved) = centred(&mut problem, loose.z, accuracy)?;
    let runs = problem.runs.clone();
    let mut problem = at(problem.border, next)?;
    problem.runs = runs;
    let (z, error) = measured(&mut problem, &z, accuracy, orbit.r_size());
    let found = read(&mut problem, family, orbit, &z, error + moved);
    *work += problem.work;
    found
}

/// Whether it may be for the errors of the integration that Newton's method did not converge.
fn is_noise(failure: &Failure<FlowError>) -> bool {
    match failure {
        Failure::ResidualRose { before, .. } => *before <= NOISY,
        Failure::NoConvergence { correction, .. } => *correction <= NOISY,
        _ => false,
    }
}

/// The unknowns at the sharper accuracy of a problem, and the error of r.
fn measured(
    problem: &mut BorderProblem<Family>,
    loose: &DVector<f64>,
    accuracy: f64,
    r_size: f64,
) -> (DVector<f64>, f64) {
    let last = loose.len() - 1;
    match correct_at(problem, loose.clone(), 0.0, accuracy) {
        Ok(tight) => {
            let apart = (tight.z[last] - loose[last]).abs();
            (tight.z, DOUBT * apart + SETTLED * accuracy * r_size)
        }
        Err(_) => (loose.clone(), accuracy * r_size),
    }
}

/// The orbit on its border with what the normal form says of it.
fn read(
    problem: &mut BorderProblem<Family>,
    family: &Family,
    near: &Orbit,
    z: &DVector<f64>,
    error: f64,
) -> Option<Edge> {
    let order = near.place.state.len();
    let (state, period, r) = (&z.as_slice()[..order], z[order], z[order + 1]);
    let at = problem.evaluate(z, 0.0).ok()?;
    let flow = family.with_magnitude(&near.magnitude()).at(r).ok()?;
    let (_, slopes) = problem.touches(z, 0.0).ok()?;
    let runs = &at.extra.runs;
    let sides = Sides::of(problem, flow.as_ref(), (state, period), (&slopes, runs)).ok()?;
    let border = problem.border.clone();
    let mut shot = problem.shot(&*flow, z, &sides.start, runs).ok()?;
    if !keeps_impacts(&sides, &border, near, &shot) {
        return None;
    }
    let residual = at.residual.norm();
    shot.closure = residual;
    shot.passages[0].derivatives = Some(sides.map(border.happens));
    let z = OrbitProblem::unknowns(std::slice::from_ref(&sides.start), period);
    let solution = Solution {
        shot: &shot,
        z: &z,
        r,
        residual,
    };
    let mut edge = Edge {
        kind: border.kind(at.extra.inwards),
        orbit: Orbit::read(family, solution, near.error_estimate, Work::default()),
        border,
        sides,
        error,
    };
    edge.orbit = edge.seen_from(near, edge.border.happens, near.heading.slope);
    Some(edge)
}

/// Whether a wall that is grazed is hit as often besides as on the orbit that comes to it: what is grazed where another impact has
/// ceased as well is the next border.
fn keeps_impacts(sides: &Sides, border: &Border, near: &Orbit, shot: &Shot) -> bool {
    if sides.kick.is_none() || border.mirror.is_some() {
        return true;
    }
    let grazed = (1.0 - border.calm) * shot.period;
    let apart = |event: &&Event| (event.time - grazed).abs() > AT_ONCE * shot.period;
    let hit = |event: &&Event| {
        event.contact == border.contact && matches!(event.kind, EventKind::Impact { .. })
    };
    let all = shot.passages.iter().flat_map(|passage| &passage.events);
    let besides = all.filter(hit).filter(apart).count();
    besides + usize::from(border.happens) == near.events.iter().filter(hit).count()
}

impl Edge {
    /// Whether no orbit continues the branch beyond it: the motion jumps, or all laps become one there, an odd number of
    /// times.
    pub(super) fn ends(&self) -> bool {
        self.jumps() || self.orbit.repeats_oddly(SAME_ORBIT)
    }

    /// Whether the motion jumps beyond it: where force drops, what would be brief is not, but for a stick on the way out.
    pub(super) fn jumps(&self) -> bool {
        self.border.drops && self.kind != Kind::CrossingSliding
    }

    /// The orbit as it is on one side of the border, in the neighbourhood of `near`; `slope` is the r-component of the tangent
    /// of the branch there.
    pub(super) fn seen_from(&self, near: &Orbit, happens: bool, slope: f64) -> Orbit {
        let zeros = self.zeros(near, happens);
        let accuracy = near.error_estimate;
        let velocity = &self.sides.velocity;
        let neutral = self.sides.runs.pins.len();
        let judged = |monodromy| {
            let all = Disturbances {
                monodromy,
                velocity: velocity.clone(),
                factors: Vec::new(),
            };
            let all = all.in_units(&near.magnitude());
            let (phi, velocity) = (&all.monodromy, &all.velocity);
            floquet(phi, velocity, None, zeros, &[], neutral, accuracy)
        };
        let mut orbit = self.orbit.clone();
        let map = match self.sides.is_unbounded(happens) {
            true => self.sides.steep(&near.magnitude()),
            false => Some(self.sides.map(happens).state),
        };
        // Where force drops, the map has no limit.
        let map = map.filter(|_| !self.border.drops);
        orbit.floquet = map.map_or_else(|| near.floquet.clone(), judged);
        // Of what is about to happen, the orbit beside it knows more than the one that is there.
        (orbit.events, orbit.segments) = (near.events.clone(), near.segments.clone());
        (orbit.heading.slope, orbit.heading.r_scale) = (slope, near.heading.r_scale);
        orbit
    }

    /// Multipliers that are zero on this side, as contacts stick there: what happens on the other one only is left out.
    fn zeros(&self, near: &Orbit, happens: bool) -> usize {
        if happens {
            most_stuck(&near.segments)
        } else {
            most_stuck(&self.border.long(near).segments)
        }
    }
}
