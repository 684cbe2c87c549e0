//! The two design variables of a curve.

use crate::field::Design;
use crate::flow::{FlowError, Steered};
use crate::integrate::Tolerance;

/// Flows for each pair of values of two design variables p and q.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane<F> {
    /// The flows at any values.
    pub family: F,
    /// What p and q stand for.
    pub designs: [Design; 2],
}

impl<F> Plane<F> {
    /// The flows along p, at this q.
    #[must_use]
    pub fn along_p<const N: usize>(&self, q: f64) -> F
    where
        F: Steered<N>,
    {
        self.family.steered(self.designs[0], self.designs[1], q)
    }

    /// The flows along q, at this p.
    #[must_use]
    pub fn along_q<const N: usize>(&self, p: f64) -> F
    where
        F: Steered<N>,
    {
        self.family.steered(self.designs[1], self.designs[0], p)
    }

    /// The flow at p and q.
    ///
    /// # Errors
    /// As [`Family::at`](crate::flow::Family::at).
    pub fn at<const N: usize>(&self, p: f64, q: f64) -> Result<F::Flow, FlowError>
    where
        F: Steered<N>,
    {
        self.along_p(q).at(p)
    }

    /// The same flows, integrated to another tolerance and measured against these magnitudes.
    #[must_use]
    pub fn tuned<const N: usize>(&self, tolerance: Tolerance, magnitude: [f64; N]) -> Self
    where
        F: Steered<N>,
    {
        let family = self.family.with_tolerance(tolerance);
        Self {
            family: family.with_magnitude(magnitude),
            designs: self.designs,
        }
    }
}
