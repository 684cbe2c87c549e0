//! The two design variables of a curve.

use crate::field::Design;
use crate::flow::FlowError;
use crate::motion::{Family, Flow};
use crate::shooting::Sheet;

/// Flows for each pair of values of two design variables p and q.
#[derive(Debug, Clone)]
pub struct Plane {
    /// The flows at any values.
    pub family: Family,
    /// What p and q stand for.
    pub designs: [Design; 2],
}

impl Sheet for Plane {
    fn along_p(&self, q: f64) -> Family {
        Self::along_p(self, q)
    }

    fn along_q(&self, p: f64) -> Option<Family> {
        Some(Self::along_q(self, p))
    }
}

impl Plane {
    /// The flows along p, at this q.
    #[must_use]
    pub fn along_p(&self, q: f64) -> Family {
        self.family.steered(self.designs[0], self.designs[1], q)
    }

    /// The flows along q, at this p.
    #[must_use]
    pub fn along_q(&self, p: f64) -> Family {
        self.family.steered(self.designs[1], self.designs[0], p)
    }

    /// The flow at p and q.
    ///
    /// # Errors
    /// As [`Flows::at`](crate::motion::Flows::at).
    pub fn at(&self, p: f64, q: f64) -> Result<Box<dyn Flow>, FlowError> {
        self.along_p(q).at(p)
    }
}
