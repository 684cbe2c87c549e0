//! What a step of one length does to any state.

use super::series::{Series, add, design};
use crate::field::{LinearField, Point};
use crate::integrate::dense::TERMS;
use crate::integrate::{Dense, Propagator};

/// The map of a step: linear in the state and the wave of the drive.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Jump<const N: usize> {
    length: f64,
    states: [Column<N>; N],
    waves: [Column<N>; 3],
}

/// What a step does to a unit of one state or one wave.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Column<const N: usize> {
    /// The terms of the dense output; the first is how far the end is off the beginning.
    path: [[f64; N]; TERMS],
    design: [f64; N],
}

impl<const N: usize> Jump<N> {
    /// The step of this length, by series with so many terms.
    pub(super) fn new(field: &LinearField<N>, length: f64, degree: usize) -> Self {
        let column = |start: Point<N>| Column {
            path: Series::new(field, &start, length, degree).path(),
            design: match field.is_designed() {
                true => design(field, &start, length, degree),
                false => [0.0; N],
            },
        };
        let nothing = Column {
            path: [[0.0; N]; TERMS],
            design: [0.0; N],
        };
        Self {
            length,
            states: crate::scalar::filled(|j| column((unit(j), [0.0; 3]))),
            waves: crate::scalar::filled(|j| match j {
                1 | 2 if !field.is_driven() => nothing,
                _ => column(([0.0; N], unit(j))),
            }),
        }
    }

    /// Its length.
    pub(super) fn length(&self) -> f64 {
        self.length
    }

    /// The way from a point.
    pub(super) fn path(&self, start: &Point<N>) -> Dense<N> {
        let mut terms = [[0.0; N]; TERMS];
        for (factor, column) in self.weighed(start) {
            for (term, more) in terms.iter_mut().zip(&column.path) {
                add(term, factor, more);
            }
        }
        Dense::of_terms(start.0, self.length, terms)
    }

    /// How the end of the way depends on its beginning and on the design variable.
    pub(super) fn propagator(&self, field: &LinearField<N>, start: &Point<N>) -> Propagator<N> {
        let mut sum = [0.0; N];
        if field.is_designed() {
            for (factor, column) in self.weighed(start) {
                add(&mut sum, factor, &column.design);
            }
        }
        let mut propagator = propagator(field, self.length, sum, |j| self.states[j].path[0]);
        if let Some((phase, turn)) = field.turn(&start.1) {
            for (factor, column) in turn.iter().zip(&self.waves) {
                for (row, rise) in propagator.state.iter_mut().zip(&column.path[0]) {
                    row[phase] += factor * rise;
                }
            }
        }
        propagator
    }

    fn weighed<'a>(&'a self, start: &'a Point<N>) -> impl Iterator<Item = (f64, &'a Column<N>)> {
        let states = start.0.iter().zip(&self.states);
        let waves = start.1.iter().zip(&self.waves);
        let all = states.chain(waves);
        all.map(|(factor, column)| (*factor, column))
    }
}

/// How the end of a single step of this length from this point depends on its beginning and on the design variable.
pub(super) fn once<const N: usize>(
    field: &LinearField<N>,
    start: &Point<N>,
    length: f64,
    degree: usize,
) -> Propagator<N> {
    let sum = match field.is_designed() {
        true => design(field, start, length, degree),
        false => [0.0; N],
    };
    let turn = field.turn(&start.1);
    propagator(field, length, sum, |j| {
        let wave = turn.filter(|(phase, _)| *phase == j);
        let wave = wave.map_or([0.0; 3], |(_, turn)| turn);
        Series::new(field, &(unit(j), wave), length, degree).rise()
    })
}

/// From how far a unit of each state rises.
fn propagator<const N: usize>(
    field: &LinearField<N>,
    length: f64,
    design: [f64; N],
    rise: impl FnMut(usize) -> [f64; N],
) -> Propagator<N> {
    let rises: [[f64; N]; N] = crate::scalar::filled(rise);
    let entry = |i: usize, j: usize| f64::from(i == j) + rises[j][i];
    Propagator {
        state: crate::scalar::filled(|i| crate::scalar::filled(|j| entry(i, j))),
        design,
        time: [0.0; N],
        trace: field.trace() * length,
    }
}

fn unit<const K: usize>(j: usize) -> [f64; K] {
    crate::scalar::filled(|i| f64::from(i == j))
}
