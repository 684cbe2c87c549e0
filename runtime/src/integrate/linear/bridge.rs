//! The dense output through a long step: from states alone, as slopes there are differences of large terms.

use std::sync::LazyLock;

use nalgebra::Matrix6;

use super::leap::Leap;
use super::series::add;
use crate::field::{LinearField, Point};
use crate::integrate::Dense;
use crate::integrate::dense::TERMS;
use crate::scalar::filled;

/// Places where states are known, from the beginning to the end.
const PLACES: usize = 9;
/// Those that it meets beside both ends: all but the middle, in eighths.
const MET: [usize; 6] = [1, 2, 3, 5, 6, 7];
/// Where it is held against what it does not meet.
const MIDDLE: usize = 4;
/// Its largest error over that in the middle: of Π (θ − θₖ) in eighths, 1335 next to the ends over 576.
const WORSE: f64 = 2.32;

/// Part of a state that its rounding errors may be: what keeps still has no terms, which would be a hundred times those.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Higher terms from how far the states are off the straight line between both ends.
static HIGHER: LazyLock<[[f64; 6]; 6]> = LazyLock::new(|| {
    let basis = |theta: f64, k: usize| {
        let (powers, mirrored) = (k / 2 + 1, k.div_ceil(2));
        theta.powi(powers as i32) * (1.0 - theta).powi(mirrored as i32)
    };
    let met = Matrix6::from_fn(|j, k| basis(place(MET[j]), k + 1));
    // Six functions that are independent on six places.
    let inverse = met.try_inverse().unwrap_or_else(Matrix6::zeros);
    filled(|k| filled(|j| inverse[(k, j)]))
});

/// Where on the step a place is, in [0, 1].
fn place(k: usize) -> f64 {
    k as f64 / (PLACES - 1) as f64
}

/// A doubled step: where it comes by, and how far its dense output is off in each state.
#[derive(Debug, Clone)]
pub(super) struct Bridge<const N: usize> {
    places: [[f64; N]; PLACES],
    /// Time from one place to the next.
    eighth: f64,
    pub(super) errors: [f64; N],
}

impl<const N: usize> Bridge<N> {
    /// From here, by steps of this map; its dense output, too.
    pub(super) fn new(
        field: &LinearField<N>,
        start: &Point<N>,
        eighth: &Leap<N>,
    ) -> (Self, Dense<N>) {
        let mut places = [start.0; PLACES];
        let mut wave = start.1;
        for k in 1..PLACES {
            places[k] = eighth.end(&(places[k - 1], wave));
            wave = field.wave(&places[k]);
        }
        let length = eighth.length * (PLACES - 1) as f64;
        let dense = Dense::of_terms(start.0, length, through(&places));
        let errors = errors(&places, &dense.state(0.5));
        let bridge = Self {
            places,
            eighth: eighth.length,
            errors,
        };
        (bridge, dense)
    }

    /// Whether its dense output is off by no more than this share of these sizes.
    pub(super) fn is_true(&self, share: f64, sizes: &[f64; N]) -> bool {
        // A comparison that fails for NaN too.
        let mut pairs = self.errors.iter().zip(sizes);
        pairs.all(|(error, size)| *error <= share * size)
    }

    /// The last place that is no further than this length, and how far it is.
    pub(super) fn before(&self, length: f64) -> (f64, [f64; N]) {
        let last = (PLACES - 2) as f64;
        let place = (length / self.eighth).floor().clamp(0.0, last);
        (place * self.eighth, self.places[place as usize])
    }

    /// The largest magnitude of each state on it.
    pub(super) fn sizes(&self) -> [f64; N] {
        let sizes = |i: usize| self.places.iter().map(move |place| place[i].abs());
        filled(|i| sizes(i).fold(0.0, f64::max))
    }
}

/// The same way up to this length, as a step of its own.
pub(super) fn shortened<const N: usize>(whole: &Dense<N>, length: f64) -> Dense<N> {
    let share = length / whole.length();
    let values = filled(|k| whole.state(share * place(k)));
    Dense::of_terms(values[0], length, through(&values))
}

/// The terms of the polynomial of degree 7 through all places but the middle.
fn through<const K: usize>(values: &[[f64; K]; PLACES]) -> [[f64; K]; TERMS] {
    let [first, .., last] = values;
    let rise = filled(|i| last[i] - first[i]);
    let mut terms = [[0.0; K]; TERMS];
    terms[0] = rise;
    for (j, k) in MET.into_iter().enumerate() {
        let off = filled(|i| {
            let off = values[k][i] - first[i] - place(k) * rise[i];
            let noise = ROUNDING * first[i].abs().max(last[i].abs());
            if off.abs() > noise { off } else { 0.0 }
        });
        for (term, weights) in terms[1..].iter_mut().zip(&*HIGHER) {
            add(term, weights[j], &off);
        }
    }
    terms
}

/// How far a polynomial with this value in the middle is off at most.
fn errors<const K: usize>(values: &[[f64; K]; PLACES], middle: &[f64; K]) -> [f64; K] {
    filled(|i| WORSE * (values[MIDDLE][i] - middle[i]).abs())
}

/// The way of a wave through a step along which it turns by an angle, and how far that is off.
pub(super) fn wave(start: &[f64; 3], angle: f64) -> (Dense<3>, [f64; 3]) {
    let (sin, cos) = (angle * place(1)).sin_cos();
    let mut values = [*start; PLACES];
    for k in 1..PLACES {
        let [one, x, y] = values[k - 1];
        values[k] = [one, x * cos - y * sin, y * cos + x * sin];
    }
    let dense = Dense::of_terms(*start, 1.0, through(&values));
    let errors = errors(&values, &dense.state(0.5));
    (dense, errors)
}
