//! Which directions at an orbit are neutral, and with what they are pinned.

use std::f64::consts::TAU;

use nalgebra::{Complex, DVector};

use super::anchor::problem;
use super::conserved::{is_conserved, is_driven, is_free};
use super::echelon::{Echelon, Free};
use super::guess::Guess;
use super::pin::Pin;
use super::problem::OrbitProblem;
use super::shift::{Shifts, slides, stops};
use super::shot::Shot;
use crate::bifurcation::floquet;
use crate::continuation::{Linearisation, ZeroProblem, correct_at};
use crate::flow::Want;
use crate::integrate::Tolerance;
use crate::linear::svd;
use crate::motion::{Family, Flow};

/// Tolerance with which it is told whether a direction is neutral.
const SHARP: f64 = 1e-12;
/// A motion that comes back this closely has come back.
const CLOSED: f64 = 1e-6;
/// One that comes back as near as this is corrected so often where that can be done.
const NEAR: f64 = 1e-2;
const CORRECTIONS: usize = 3;
/// Singular values below this share of the largest are zero; a multiplier so near to 1 singles out no orbit.
const NEUTRAL: f64 = 1e-7;
/// The same for a matrix that is known roughly.
pub(super) const SUSPECT: f64 = 1e-4;
/// A motion that misses closing by more than this, sharply followed, does not close.
const DRIFT: f64 = 1e-9;
/// Periods after which a motion that closes is looked at again, and how many times as far as after one, for each of them, it may
/// be from where it was.
const LATER: u32 = 1000;
const FARTHER: f64 = 100.0;
/// A state that swings by less than this share of its usual size has died away.
const DIED: f64 = 1e-2;
/// How near a motion comes back at best.
const FINEST: f64 = 1e-12;
/// How far a neighbour is sought, in units of the condition: some have none but very near. How well it must close, over that.
const ASIDE: [f64; 2] = [1e-3, 1e-5];
const NEIGHBOUR: f64 = 1e-5;

/// Whether the equations at an orbit known roughly may be singular.
pub(super) fn suspect(linearisation: &Linearisation<Shot>, scale: &DVector<f64>) -> bool {
    let decomposed = svd(linearisation.scaled(scale));
    decomposed.is_some_and(|svd| svd.singular_values.min() <= SUSPECT * svd.singular_values.max())
}

/// The problem at a guess, its unknowns and its linearisation, followed so sharply that neutral directions show; `None`
/// if the motion does not come back.
fn sharply(
    family: &Family,
    r: f64,
    guess: &Guess,
) -> Option<(OrbitProblem, DVector<f64>, Linearisation<Shot>)> {
    let family = family
        .with_tolerance(Tolerance::for_accuracy(SHARP))
        .with_magnitude(&guess.magnitude);
    let (mut problem, mut z) = problem(family, r, guess, 1).ok()?;
    let mut at = problem.evaluate(&z, r).ok()?;
    for _ in 0..CORRECTIONS {
        let gap = at.residual.norm();
        if gap <= CLOSED || gap > NEAR {
            break;
        }
        z += correction(&at, &problem.scale())?;
        at = problem.evaluate(&z, r).ok()?;
    }
    (at.residual.norm() <= CLOSED).then_some((problem, z, at))
}

/// The motion that comes back nearest to a guess, if it has neighbours that do so as well, whatever they are.
///
/// A motion that misses closing in a direction in which no correction of its start or its period helps goes on in that
/// direction, however slowly: then neither it nor its neighbours are periodic.
pub(super) fn neutral(family: &Family, r: f64, guess: &Guess) -> Option<Guess> {
    let (mut problem, z, at) = sharply(family, r, guess)?;
    let z = z + correction(&at, &problem.scale())?;
    let at = problem.evaluate(&z, r).ok()?;
    let shot = &at.extra;
    if has_died_away(shot, &problem.magnitude) {
        return None;
    }
    let (monodromy, _) = shot.monodromy();
    let multipliers = floquet(&monodromy, &shot.velocity.f, None, 0, &[], 0, NEUTRAL);
    let one = Complex::new(1.0, 0.0);
    let near = |multiplier: &Complex<f64>| (multiplier - one).norm() <= NEUTRAL;
    let closes = at.residual.norm() <= DRIFT && multipliers.multipliers.iter().any(near);
    let stays = closes && stays(&problem, r, &at)?;
    stays.then(|| Guess {
        place: shot.start.clone(),
        period: shot.period,
        ..guess.clone()
    })
}

/// Whether no state swings by what is usual for it: what is left of a motion that comes to rest has neighbours that rest, too.
fn has_died_away(shot: &Shot, magnitude: &[f64]) -> bool {
    let (low, high) = shot.extent();
    let run = |j: usize| shot.shift.as_ref().map_or(0.0, |run| run[j].abs());
    (0..low.len()).all(|j| high[j] - low[j] - run(j) <= DIED * magnitude[j])
}

/// Whether a motion that closes after a period does so after many. One that hardly moves while it vibrates misses by less than
/// can be told; but as it sets off, that grows by the square of the time. Where errors change how fast it vibrates, it is late.
fn stays(problem: &OrbitProblem, r: f64, at: &Linearisation<Shot>) -> Option<bool> {
    let (shot, magnitude) = (&at.extra, &problem.magnitude);
    let flow = problem.family.at(r).ok()?;
    let mut place = shot.start.clone();
    for _ in 0..LATER {
        place = flow.advance(&place, shot.period, Want::default()).ok()?.end;
        place.state = flow.wrapped(place.state);
    }
    let scaled = |from: Vec<f64>| {
        let all = from.iter().zip(magnitude).map(|(value, unit)| value / unit);
        DVector::from_iterator(from.len(), all)
    };
    let run = |j: usize| shot.shift.as_ref().map_or(0.0, |run| run[j]);
    let gap = |j: usize| place.state[j] - shot.start.state[j] - f64::from(LATER) * run(j);
    let mut gaps: Vec<f64> = (0..magnitude.len()).map(gap).collect();
    if let Some(phase) = flow.phase() {
        gaps[phase] -= TAU * (gaps[phase] / TAU).round();
    }
    let mut missed = scaled(gaps);
    if let Some(along) = scaled(shot.velocity.f.as_slice().to_vec()).try_normalize(0.0) {
        missed.axpy(-along.dot(&missed), &along, 1.0);
    }
    let once = at.residual.norm().max(FINEST);
    Some(missed.norm() <= FARTHER * f64::from(LATER) * once)
}

/// Newton's correction, of the least size, in those directions that are not neutral.
fn correction(at: &Linearisation<Shot>, scale: &DVector<f64>) -> Option<DVector<f64>> {
    let svd = svd(at.scaled(scale))?;
    let least = SUSPECT * svd.singular_values.max();
    let found = svd.solve(&-&at.residual, least).ok()?;
    Some(found.component_mul(scale))
}

/// The conditions that single out the orbit of a guess among its neighbours; none if they are no orbits, or the guess is
/// none.
pub(super) fn pins(family: &Family, r: f64, guess: &Guess) -> Vec<Pin> {
    pinned(family, r, guess).unwrap_or_default()
}

fn pinned(family: &Family, r: f64, guess: &Guess) -> Option<Vec<Pin>> {
    let (problem, z, at) = sharply(family, r, guess)?;
    let flow = problem.family.at(r).ok()?;
    let (order, magnitude) = (guess.magnitude.len(), &guess.magnitude);
    let at = held_beside_shifts(flow.as_ref(), at, &problem.scale(), magnitude);
    let Null { left, right } = Null::of(&at, &problem.scale())?;
    let constant = Echelon::of(&left, order, &[]).conditions(magnitude);
    let right_by = Echelon::of(&right, order, &[]);
    let directions = right_by.directions(magnitude);
    let free = |shift| is_free(flow.as_ref(), shift, magnitude, &at.extra);
    let free = right.iter().all(free);
    // What is free goes on where it changes: a carriage that friction holds may run on, but a state with stops may not.
    let runs = |(_, direction): &Free| {
        !stops(flow.as_ref(), direction) && slides(flow.as_ref(), direction, magnitude)
    };
    let held = |c: &Vec<f64>| is_conserved(flow.as_ref(), c, &at.extra, magnitude);
    let conserved = constant.iter().all(held) && !(free && directions.iter().all(runs));
    let driven = |c: &Vec<f64>| is_driven(flow.as_ref(), c, &at.extra, magnitude);
    let driven = !conserved && !free && constant.iter().all(driven);
    let (chosen, directions): (_, Vec<_>) = if driven || conserved {
        let directions = constant.iter().map(|_| None).collect();
        (constant, directions)
    } else if free {
        let chosen = right_by.conditions(magnitude);
        (chosen, directions.into_iter().map(Some).collect())
    } else {
        return None;
    };
    let chosen = chosen.into_iter().zip(directions);
    let pins: Vec<Pin> = chosen
        .zip(left)
        .map(|((mut combination, direction), left)| {
            if let Some(phase) = flow.phase().filter(|_| driven) {
                combination[phase] = 0.0;
            }
            let pin = Pin {
                combination,
                value: 0.0,
                told: 0.0,
                direction,
                driven,
                centred: None,
                left,
            };
            pin.told(&guess.place.state)
        })
        .collect();
    (0..pins.len())
        .all(|i| has_neighbour(&problem, &z, r, &pins, i))
        .then_some(pins)
}

/// The same equations, the phase held by what no shift moves: where a shift moves along the orbit as well, what is neutral is part
/// shift and part motion, and would be told as neither.
fn held_beside_shifts(
    flow: &dyn Flow,
    mut at: Linearisation<Shot>,
    scale: &DVector<f64>,
    magnitude: &[f64],
) -> Linearisation<Shot> {
    let phase = at.jacobian.nrows() - 1;
    let mut held = at.jacobian.row(phase).transpose().component_mul(scale);
    let whole = held.norm();
    let mut known: Vec<DVector<f64>> = Vec::new();
    for direction in Shifts::of(flow, magnitude).directions() {
        let mut shift = DVector::from_column_slice(direction)
            .push(0.0)
            .component_div(scale);
        for other in &known {
            shift.axpy(-other.dot(&shift), other, 1.0);
        }
        if let Some(shift) = shift.try_normalize(0.0) {
            held.axpy(-shift.dot(&held), &shift, 1.0);
            known.push(shift);
        }
    }
    if held.norm() > NEUTRAL * whole {
        at.jacobian
            .set_row(phase, &held.component_div(scale).transpose());
    }
    at
}

/// What h_z takes to zero, and the sums of equations that it leaves empty, in units of the unknowns.
pub(super) struct Null {
    pub(super) left: Vec<DVector<f64>>,
    pub(super) right: Vec<DVector<f64>>,
}

impl Null {
    /// `None` where h_z is regular.
    pub(super) fn of(at: &Linearisation<Shot>, scale: &DVector<f64>) -> Option<Self> {
        Self::within(at, scale, NEUTRAL)
    }

    /// The same of what it takes to less than this share of what it makes of others.
    pub(super) fn within(
        at: &Linearisation<Shot>,
        scale: &DVector<f64>,
        share: f64,
    ) -> Option<Self> {
        let svd = svd(at.scaled(scale))?;
        let (u, vt) = (svd.u?, svd.v_t?);
        let limit = share * svd.singular_values.max();
        let null = |i: &usize| svd.singular_values[*i] <= limit;
        let null: Vec<usize> = (0..scale.len()).filter(null).collect();
        let left = null.iter().map(|&i| u.column(i).into_owned()).collect();
        let right = null.iter().map(|&i| vt.row(i).transpose()).collect();
        (!null.is_empty()).then_some(Self { left, right })
    }
}

/// Whether there is an orbit to one side of this condition: at a fold, or at a branch point, there is none.
fn has_neighbour(
    problem: &OrbitProblem,
    z: &DVector<f64>,
    r: f64,
    pins: &[Pin],
    moved: usize,
) -> bool {
    ASIDE.iter().any(|aside| {
        let mut problem = problem.clone();
        problem.pins = pins.to_vec();
        problem.pins[moved].value += aside * pins[moved].unit(&problem.magnitude);
        let closed = NEIGHBOUR * aside;
        let found = correct_at(&mut problem, z.clone(), r, closed);
        found.is_ok_and(|found| found.linearisation.extra.closure <= closed)
    })
}
