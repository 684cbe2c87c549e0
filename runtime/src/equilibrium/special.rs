//! Points of a branch of equilibria where something changes.

use nalgebra::{DMatrix, DVector};

use super::Spectrum;

/// What changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// The branch turns.
    Fold,
    /// A complex pair crosses the imaginary axis: periodic orbits begin here.
    Hopf,
    /// An eigenvalue passes through zero, but the branch does not turn: another one crosses it.
    BranchPoint,
    /// The relative speed of a contact reaches zero: its mode ends.
    BoundaryEquilibrium,
}

impl Kind {
    /// The word for it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Fold => "fold",
            Self::Hopf => "hopf",
            Self::BranchPoint => "branch-point",
            Self::BoundaryEquilibrium => "boundary-equilibrium",
        }
    }

    /// The letters with which its points are numbered.
    #[must_use]
    pub const fn letters(self) -> &'static str {
        match self {
            Self::Fold => "LP",
            Self::Hopf => "HB",
            Self::BranchPoint => "BP",
            Self::BoundaryEquilibrium => "BE",
        }
    }

    /// By how many the number of unstable eigenvalues changes there, up to its sign; `None` if by any.
    pub(super) const fn crossing(self) -> Option<usize> {
        match self {
            Self::Fold | Self::BranchPoint => Some(1),
            Self::Hopf => Some(2),
            Self::BoundaryEquilibrium => None,
        }
    }
}

/// A point of a branch of equilibria.
#[derive(Debug, Clone)]
pub struct Spot {
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
    pub(super) tangent_r: f64,
    /// Sign of the product of all eigenvalues.
    pub(super) determinant: f64,
}

impl Spot {
    /// The test function of a kind; it changes sign there.
    pub(super) fn test(&self, kind: Kind) -> f64 {
        match kind {
            Kind::Fold => self.tangent_r,
            Kind::Hopf => self.spectrum.hopf_test(),
            Kind::BranchPoint => self.determinant,
            Kind::BoundaryEquilibrium => {
                let margins = self.margins.iter().map(|(_, margin)| *margin);
                margins.fold(f64::INFINITY, f64::min)
            }
        }
    }

    pub(super) fn unknowns(&self) -> DVector<f64> {
        DVector::from_column_slice(&self.state)
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

/// A special point.
#[derive(Debug, Clone)]
pub struct Found {
    /// What it is.
    pub kind: Kind,
    /// Where it is.
    pub spot: Spot,
}
