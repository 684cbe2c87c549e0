//! How the end of a motion depends on its beginning where it is not longer than a step, whatever its length.

use super::leap::{Leap, Map};
use super::series::{Series, design, unit};
use crate::field::{LinearField, Point, Strip};
use crate::integrate::Propagator;
use crate::scalar::filled;

/// The terms of the map of a step, (A h)ᵏ/k! and what the wave of the drive adds to them: those of a part θ of it are θᵏ times
/// as large.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Powers<const N: usize> {
    length: f64,
    terms: Box<[Map<N>]>,
}

impl<const N: usize> Powers<N> {
    /// Those of a step of this length, so many.
    pub(super) fn new(field: &LinearField<N>, length: f64, degree: usize) -> Self {
        let series = |start| Series::new(field, &start, length, degree);
        let states: Vec<_> = (0..N).map(|j| series((unit(j), [0.0; 3]))).collect();
        let waves: [_; 3] = filled(|j| series(([0.0; N], unit(j))));
        let terms = (1..=degree).map(|k| Map {
            states: filled(|i| Strip::of_matrix(filled(|j| states[j].term(k)[i]))),
            waves: filled(|i| filled(|j: usize| waves[j].term(k)[i])),
        });
        Self {
            length,
            terms: terms.collect(),
        }
    }

    /// How the end of a motion of this length, not longer than a step, depends on where it begins.
    pub(super) fn propagator(
        &self,
        field: &LinearField<N>,
        start: &Point<N>,
        length: f64,
    ) -> Propagator<N> {
        let mut power = 1.0;
        let mut own = Map::NOTHING;
        for term in &self.terms {
            power *= length / self.length;
            own.add(power, term);
        }
        let leap = Leap {
            length,
            own,
            along: None,
        };
        let design = match field.is_designed() {
            true => design(field, start, length, self.terms.len()),
            false => [0.0; N],
        };
        Propagator {
            design,
            ..leap.propagator(field, start)
        }
    }
}
