//! A piece of a step, as a series: a state anywhere in it, as true as its end.

use super::LinearFlow;
use super::series::Series;
use crate::field::Point;

/// The series of a piece of a step.
#[derive(Debug, Clone)]
pub(super) struct Piece<const N: usize> {
    from: f64,
    length: f64,
    pub(super) series: Series<N>,
}

impl<const N: usize> Piece<N> {
    /// From so far on in a step, where this point is.
    pub(super) fn new(flow: &LinearFlow<N>, from: f64, point: &Point<N>, length: f64) -> Self {
        Self {
            from,
            length,
            series: Series::new(&flow.field, point, length, flow.degree),
        }
    }

    /// Whether this length ends in it.
    pub(super) fn reaches(&self, length: f64) -> bool {
        self.from <= length && length <= self.from + self.length
    }

    /// The state where a step of this length ends.
    pub(super) fn state(&self, length: f64) -> [f64; N] {
        self.series.state((length - self.from) / self.length)
    }
}
