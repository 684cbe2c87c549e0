//! What a step of one length does to any state.

use super::leap::{Leap, Map};
use super::series::{Series, design, unit};
use crate::field::{LinearField, Point, Strip};
use crate::integrate::Dense;
use crate::integrate::dense::TERMS;
use crate::scalar::filled;

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
    path: [Strip<N>; TERMS],
    design: Strip<N>,
}

impl<const N: usize> Jump<N> {
    /// The step of this length, by series with so many terms.
    pub(super) fn new(field: &LinearField<N>, length: f64, degree: usize) -> Self {
        let column = |start: Point<N>, designed: bool| Column {
            path: Series::new(field, &start, length, degree)
                .path()
                .map(Strip::of_matrix),
            design: match designed {
                true => Strip::of_matrix(design(field, &start, length, degree)),
                false => Strip::ZERO,
            },
        };
        let bends = field.bends();
        let nothing = Column {
            path: [Strip::ZERO; TERMS],
            design: Strip::ZERO,
        };
        Self {
            length,
            states: filled(|j| column((unit(j), [0.0; 3]), bends)),
            waves: filled(|j| match j {
                1 | 2 if !field.is_driven() => nothing,
                _ => column(([0.0; N], unit(j)), field.is_designed()),
            }),
        }
    }

    /// Its length.
    pub(super) fn length(&self) -> f64 {
        self.length
    }

    /// The way from a point.
    #[inline]
    pub(super) fn path(&self, start: &Point<N>) -> Dense<N> {
        let mut terms = [[0.0; N]; TERMS];
        for (factor, column) in self.weighed(start) {
            for (term, more) in terms.iter_mut().zip(&column.path) {
                more.add_to(term, factor);
            }
        }
        Dense::of_terms(start.0, self.length, terms)
    }

    /// The map from its beginning to its end.
    pub(super) fn leap(&self, designed: bool) -> Leap<N> {
        let map = |part: fn(&Column<N>) -> &Strip<N>| Map {
            states: filled(|i| Strip::of_matrix(filled(|j| part(&self.states[j]).entries()[i]))),
            waves: filled(|i| filled(|k| part(&self.waves[k]).entries()[i])),
        };
        Leap {
            length: self.length,
            own: map(|column| &column.path[0]),
            along: designed.then(|| map(|column| &column.design)),
        }
    }

    fn weighed<'a>(&'a self, start: &'a Point<N>) -> impl Iterator<Item = (f64, &'a Column<N>)> {
        let states = start.0.iter().zip(&self.states);
        let waves = start.1.iter().zip(&self.waves);
        let all = states.chain(waves);
        all.map(|(factor, column)| (*factor, column))
    }
}
