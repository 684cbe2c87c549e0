//! Points of a branch of equilibria, and what is looked for on it.

use nalgebra::DMatrix;

use super::Spectrum;
use crate::continuation::{Kind, Monitor, Monitors, Verdict, Watched, changes};

/// A point of a branch of equilibria.
#[derive(Debug, Clone)]
pub struct EquilibriumPoint {
    /// The state.
    pub state: Vec<f64>,
    /// The design variable.
    pub r: f64,
    /// Its eigenvalues.
    pub spectrum: Spectrum,
    /// Norm of the residual.
    pub residual: f64,
    /// Of each sliding contact, see [`Flow::margins`](crate::motion::Flow::margins).
    pub margins: Vec<(usize, f64)>,
    /// r-component of the unit tangent: changes sign at a fold.
    pub(super) slope: f64,
    /// Sign of the product of all eigenvalues.
    pub(super) determinant: f64,
}

impl EquilibriumPoint {
    /// The least relative speed of a sliding contact the way it slides, and its number.
    #[must_use]
    pub fn margin(&self) -> Option<(usize, f64)> {
        let margins = self.margins.iter().copied();
        margins.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Its Jacobian's determinant, of rows of length 1.
    pub(super) fn determinant_of(jacobian: &DMatrix<f64>) -> f64 {
        let mut rows = jacobian.clone();
        for mut row in rows.row_iter_mut() {
            let length = row.norm();
            if length > 0.0 {
                row /= length;
            }
        }
        rows.determinant()
    }
}

impl Watched for EquilibriumPoint {
    fn r(&self) -> f64 {
        self.r
    }

    fn slope(&self) -> f64 {
        self.slope
    }

    fn unstable(&self) -> usize {
        self.spectrum.unstable
    }

    fn is_certain(&self) -> bool {
        true
    }
}

/// Folds, Hopf and branch points, and where a contact no longer slides as it did.
pub(super) fn monitors<'a>() -> Monitors<'a, EquilibriumPoint> {
    type Point = EquilibriumPoint;
    // At a sharp corner the tangent alone may point backwards, but no eigenvalue passes zero.
    let passes = |[from, to]: [&Point; 2]| changes(from.determinant, to.determinant);
    let hopf = Monitor::new(Kind::Hopf, |point: &Point| point.spectrum.hopf_test());
    let boundary = |point: &Point| point.margin().map_or(f64::INFINITY, |(_, margin)| margin);
    Monitors::smooth(vec![
        Monitor::new(Kind::Fold, Point::slope).only_if(passes),
        Monitor::new(Kind::BranchPoint, |point: &Point| point.determinant)
            .only_if(|ends| !turns(ends)),
        hopf.judged(|_, at| {
            let frequency = at.spectrum.critical_frequency();
            frequency.map(|_| Verdict::Special(Kind::Hopf))
        }),
        Monitor::new(Kind::BoundaryEquilibrium, boundary)
            .judged(|_, _| Some(Verdict::Last(Kind::BoundaryEquilibrium))),
    ])
}

/// Whether the branch turns.
pub(super) fn turns([from, to]: [&EquilibriumPoint; 2]) -> bool {
    changes(from.slope, to.slope) && changes(from.determinant, to.determinant)
}
