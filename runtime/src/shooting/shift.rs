//! Shifts of states that change nothing: an angle that has turned, a carriage that has moved on.
//!
//! Where no rate depends on where the states are along a direction, a motion that has moved on along it is as good as one
//! that has come back, and so is one in which an angle has turned once, or a tip has passed an atom. Orbits are sought modulo
//! such shifts. A wall is not felt before it is hit, nor what a constant force opposes: gaps and relative speeds must not
//! depend on it either.

use std::f64::consts::TAU;

use nalgebra::DMatrix;

use super::course::{courses, sharper};
use super::echelon::{Echelon, Free};
use super::moved::moved;
use super::tried::{TRIED, slopes_of_speeds, spread};
use super::wavelength::wavelengths;
use crate::linear::svd;
use crate::motion::{Flow, apart};

/// How many states at which a shift is tried must have rates.
const KNOWN: usize = 3;
/// Rates that agree to this share of their sizes are the same.
const SAME: f64 = 1e-7;
/// A shift this small, in usual sizes, is none.
const SMALL: f64 = 1e-6;
/// Singular values below this share of the largest are zero.
const FREE: f64 = 1e-9;
/// Most parts of a turn that may change nothing: steps of a motor, blades, teeth.
const PARTS: u32 = 400;
/// How far from half a turn it is that is rounded up: what turns by simple parts is not to hang on rounding errors.
const ASIDE: f64 = 0.118_034;
/// Shares of a shift that are tried: no two are parts of each other.
const SHARES: [f64; 2] = [1.0, 0.618_034];

/// The shifts of one flow that change nothing.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Shifts {
    /// Directions of any shift.
    directions: Vec<Free>,
    /// The least shifts after which all repeats: parts of a turn of one state, or of several together, and lengths.
    angles: Vec<Free>,
    phase: Option<usize>,
}

impl Shifts {
    /// Those that states of `usual` sizes show.
    pub(crate) fn of(flow: &dyn Flow, usual: &[f64]) -> Self {
        let phase = flow.phase();
        let mut directions = directions(flow, usual);
        directions.retain(|(_, direction)| slides(flow, direction, usual));
        let turns = |j: usize, parts: u32| {
            let mut turn = vec![0.0; usual.len()];
            turn[j] = TAU / f64::from(parts);
            changes_nothing(flow, &turn, usual)
        };
        let angle = |j: usize| {
            let moves = directions.iter().any(|(_, d)| d[j] != 0.0);
            if phase == Some(j) || moves || !turns(j, 1) {
                return None;
            }
            let parts = (1..=PARTS).rev().find(|parts| turns(j, *parts))?;
            Some(alone(j, TAU / f64::from(parts), usual.len()))
        };
        let mut angles: Vec<Free> = (0..usual.len()).filter_map(angle).collect();
        let known = directions.iter().chain(&angles).map(|(pivot, _)| *pivot);
        let known: Vec<usize> = known.chain(phase).collect();
        let others = courses(flow, usual, &known);
        angles.extend(
            others
                .iter()
                .filter_map(|course| length(flow, course, usual)),
        );
        Self {
            directions,
            angles,
            phase,
        }
    }

    /// Directions of shifts of any length.
    pub(super) fn directions(&self) -> impl Iterator<Item = &[f64]> {
        self.directions
            .iter()
            .map(|(_, direction)| direction.as_slice())
    }

    /// Whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.directions.is_empty() && self.angles.is_empty()
    }

    /// Whether a state can go on for ever and the motion repeat.
    pub(crate) fn may_run(&self, state: usize) -> bool {
        let moved = |(_, direction): &Free| direction[state] != 0.0;
        self.angles.iter().chain(&self.directions).any(moved)
    }

    /// What of the way between two states is a shift that changes nothing.
    pub(crate) fn between(&self, from: &[f64], to: &[f64]) -> Vec<f64> {
        let mut rest = gain(from, to);
        let mut shift = vec![0.0; rest.len()];
        for (pivot, direction) in &self.directions {
            let along = rest[*pivot] / direction[*pivot];
            for (j, d) in direction.iter().enumerate() {
                rest[j] -= along * d;
                shift[j] += along * d;
            }
        }
        let turns = self.turns(&rest);
        shift.iter().zip(&turns).map(|(a, b)| a + b).collect()
    }

    /// What of a way is whole shifts: a body that may stand anywhere stays where it is.
    pub(crate) fn turns(&self, way: &[f64]) -> Vec<f64> {
        let mut shift = vec![0.0; way.len()];
        for (pivot, turn) in &self.angles {
            let turns = (way[*pivot] / turn[*pivot] + ASIDE).round();
            for (gain, turn) in shift.iter_mut().zip(turn) {
                *gain += turns * turn;
            }
        }
        shift
    }

    /// The state moved by such a shift to the origin, as far as one leads there.
    pub(crate) fn home(&self, state: &[f64]) -> Vec<f64> {
        self.beside(state, &vec![0.0; state.len()])
    }

    /// The state moved by such a shift to where it is next to a point.
    pub(crate) fn beside(&self, state: &[f64], point: &[f64]) -> Vec<f64> {
        if self.is_empty() {
            return state.to_vec();
        }
        moved(state, &self.between(point, state), 1.0)
    }

    /// How far a state is from a point in these units, but for such shifts.
    pub(crate) fn apart(&self, state: &[f64], point: &[f64], units: &[f64]) -> f64 {
        match self.is_empty() {
            true => apart(state, point, units),
            false => apart(&self.beside(state, point), point, units),
        }
    }

    /// The shift between two states, if no state lacks more than `closeness` in these units besides; `None` also where the
    /// shift is no larger than that.
    pub(crate) fn within(
        &self,
        [from, to]: [&[f64]; 2],
        units: &[f64],
        closeness: f64,
    ) -> Option<Vec<f64>> {
        let shift = self.between(from, to);
        let mut gain = gain(from, to);
        if let Some(phase) = self.phase {
            gain[phase] = 0.0;
        }
        let nothing = vec![0.0; shift.len()];
        let closes = apart(&gain, &shift, units) <= closeness;
        (closes && apart(&shift, &nothing, units) > closeness).then_some(shift)
    }
}

/// This shift of one state.
fn alone(state: usize, by: f64, order: usize) -> Free {
    let mut shift = vec![0.0; order];
    shift[state] = by;
    (state, shift)
}

/// The least shift along a course after which all repeats.
fn length(flow: &dyn Flow, (pivot, course): &Free, usual: &[f64]) -> Option<Free> {
    let repeats = |length: f64| {
        let shift: Vec<f64> = course.iter().map(|d| length * d).collect();
        let shift = sharper(flow, &shift, usual)?;
        changes_nothing(flow, &shift, usual).then_some((*pivot, shift))
    };
    let units = usual.iter().zip(course).filter(|(_, d)| **d != 0.0);
    let unit = units.map(|(unit, d)| (unit / d).abs());
    let unit = unit.fold(f64::INFINITY, f64::min);
    let known = |place: &Vec<f64>| wavelengths(flow, place, course, unit).find_map(repeats);
    spread(usual).take(KNOWN).find_map(|place| known(&place))
}

fn gain(from: &[f64], to: &[f64]) -> Vec<f64> {
    to.iter().zip(from).map(|(to, from)| to - from).collect()
}

/// Directions in which no slope of the rates, gaps and relative speeds points, anywhere, in units of the states.
fn directions(flow: &dyn Flow, usual: &[f64]) -> Vec<Free> {
    let order = usual.len();
    let mut rows = Vec::new();
    if let Some(phase) = flow.phase() {
        rows.push((0..order).map(|j| f64::from(j == phase)).collect());
    }
    for state in spread(usual) {
        let velocity = flow.place(&state).and_then(|place| flow.velocity(&place));
        let Ok(velocity) = velocity else {
            continue;
        };
        let rates = velocity.jacobian.row_iter();
        let rates = rates.map(|row| row.iter().zip(usual).map(|(s, size)| s * size).collect());
        for slopes in rates.chain(slopes_of_speeds(flow, &state, usual)) {
            let largest = slopes
                .iter()
                .fold(0.0_f64, |most, s: &f64| most.max(s.abs()));
            if largest > 0.0 && slopes.iter().all(|s| s.is_finite()) {
                rows.push(slopes.iter().map(|s| s / largest).collect());
            }
        }
    }
    while rows.len() < order {
        rows.push(vec![0.0; order]);
    }
    let matrix = DMatrix::from_fn(rows.len(), order, |i, j| rows[i][j]);
    let Some((values, vt)) = svd(matrix).and_then(|svd| Some((svd.singular_values, svd.v_t?)))
    else {
        return Vec::new();
    };
    let least = FREE * values.max();
    let null = (0..order).filter(|i| values[*i] <= least);
    let null: Vec<_> = null.map(|i| vt.row(i).transpose()).collect();
    Echelon::of(&null, order, &[]).directions(usual)
}

/// Whether a direction moves the internal state of a law that has stops: it may be shifted, but does not go on.
pub(super) fn stops(flow: &dyn Flow, direction: &[f64]) -> bool {
    let mut moved = direction.iter().enumerate().filter(|(_, d)| **d != 0.0);
    moved.any(|(j, _)| flow.stop(j).is_finite())
}

/// Whether any share of a shift changes nothing.
pub(crate) fn slides(flow: &dyn Flow, shift: &[f64], usual: &[f64]) -> bool {
    SHARES.iter().all(|share| {
        let part: Vec<f64> = shift.iter().map(|d| share * d).collect();
        changes_nothing(flow, &part, usual)
    })
}

/// Whether rates, gaps and relative speeds are the same everywhere after this shift, as far as states of `usual` sizes tell.
pub(crate) fn changes_nothing(flow: &dyn Flow, shift: &[f64], usual: &[f64]) -> bool {
    let mut shares = shift.iter().zip(usual).map(|(d, size)| d.abs() / size);
    shares.any(|share| share > SMALL) && keeps_rates(flow, shift, usual)
}

/// The same of a shift of any size.
pub(super) fn keeps_rates(flow: &dyn Flow, shift: &[f64], usual: &[f64]) -> bool {
    let rates = |state: &[f64]| {
        let place = flow.place(state).ok()?;
        Some((flow.velocity(&place).ok()?.f, place.modes))
    };
    let places: Vec<Vec<f64>> = spread(usual).collect();
    if !keeps_speeds(flow, shift, &places) {
        return false;
    }
    let known: Vec<_> = places.iter().map(|here| rates(here)).collect();
    // Each rate in its own size: those of others have other units.
    let size = |j: usize| {
        known
            .iter()
            .flatten()
            .map(|(f, _)| f[j].abs())
            .fold(0.0, f64::max)
    };
    let sizes: Vec<f64> = (0..usual.len()).map(size).collect();
    let same = |k: usize| match (&known[k], rates(&moved(&places[k], shift, -1.0))) {
        (Some((f, modes)), Some((g, other))) => {
            let off = f - g;
            *modes == other && (0..sizes.len()).all(|j| off[j].abs() <= SAME * sizes[j])
        }
        // Behind a wall no motion begins.
        (here, there) => here.is_none() && there.is_none(),
    };
    known.iter().flatten().count() >= KNOWN && (0..TRIED).all(same)
}

/// Whether gaps and relative speeds are the same at all these places after a shift, but for those that have no value.
fn keeps_speeds(flow: &dyn Flow, shift: &[f64], places: &[Vec<f64>]) -> bool {
    let pairs = places.iter().map(|here| {
        let there = flow.speeds(&moved(here, shift, -1.0));
        (flow.speeds(here), there)
    });
    let pairs: Vec<_> = pairs.collect();
    let same = |i: usize| {
        let sizes = pairs.iter().map(|(here, _)| here[i].abs());
        let size = sizes.fold(0.0, f64::max);
        let mut differ = pairs.iter().map(|(here, there)| (here[i] - there[i]).abs());
        !differ.any(|differ| differ > SAME * size)
    };
    (0..pairs.first().map_or(0, |(here, _)| here.len())).all(same)
}
