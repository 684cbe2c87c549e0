//! What is asked and reported of a curve.

use nalgebra::Complex;
use serde::Serialize;

use crate::continuation::Kind;
use crate::field::Work;
use crate::study::branch::BranchRecord;
use crate::study::ended::Ended;
use crate::study::equilibria::EquilibriumRecord;
use crate::study::orbit::OrbitRecord;
use crate::study::question::Along;

/// Which bifurcation is followed, and along what besides the design variable of the case.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveScope {
    /// The second design variable; the case holds its beginning.
    pub and: Along,
    /// The label of a special point of the branch; the first that can be followed if nothing is said.
    pub of: Option<String>,
}

/// What came of a curve that starts from a branch of orbits, or from one of equilibria.
#[derive(Debug, Clone, PartialEq)]
pub enum Curved<B = BranchRecord> {
    /// It was followed.
    Followed(Box<CurveRecord<B>>),
    /// The branch of the special point was interrupted before the curve began; as far as it came.
    Interrupted(Box<B>),
}

impl<B> Curved<B> {
    /// The curve, if there is one.
    #[must_use]
    pub fn followed(self) -> Option<CurveRecord<B>> {
        match self {
            Self::Followed(curve) => Some(*curve),
            Self::Interrupted(_) => None,
        }
    }
}

/// A curve as it is reported, whatever model it belongs to.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveRecord<B = BranchRecord> {
    /// The branch from which it starts.
    pub branch: B,
    /// The first design variable and its range.
    pub along: Along,
    /// The second.
    pub and: Along,
    /// The label of the special point from which it starts.
    pub of: String,
    /// What it is a curve of: `fold`, `flip`, `torus`, `grazing-sliding`, `hopf`.
    pub kind: Kind,
    /// Its points in the order in which they were found.
    pub points: Vec<CurvePointRecord>,
    /// Points of codimension two.
    pub special: Vec<SpecialCurvePoint>,
    /// Why it ended.
    pub ended: Ended,
    /// What it cost, without the branch from which it starts.
    pub work: Work,
}

/// A special orbit, or a special equilibrium.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CurvePointRecord {
    /// The first design variable, in the user's own values.
    #[serde(skip)]
    pub p: f64,
    /// The second.
    #[serde(skip)]
    pub q: f64,
    /// Its period, or that of the small orbits that begin at a Hopf point; none at a fold of equilibria.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub period: Option<f64>,
    /// A state of the orbit, where the first state is least, or where the orbit grazes; or the equilibrium.
    pub state: Vec<f64>,
    /// Multipliers of an orbit; none where it grazes.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub multipliers: Vec<Complex<f64>>,
    /// Eigenvalues of an equilibrium.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub eigenvalues: Vec<Complex<f64>>,
    /// The first Lyapunov coefficient of a Hopf point, with an eigenvector of length 1; none where it is not known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub l1: Option<f64>,
    /// Its estimated error.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub l1_error: Option<f64>,
    /// Whether periodic motions begin there `soft` or `hard`, as far as that coefficient tells.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub onset: Option<&'static str>,
    /// Norm of the residual of its equations.
    pub residual: f64,
    /// The condition that makes it special, as it was met.
    pub test: f64,
}

/// A point of codimension two.
#[derive(Debug, Clone, PartialEq)]
pub struct SpecialCurvePoint {
    /// What: `cusp`, `isola-centre`, `fold-flip`, `generalized-hopf`, ...
    pub kind: Kind,
    /// Kind and number, for instance `CP1`.
    pub label: String,
    /// Along what the branches are followed that appear or meet there while the other variable changes; none at other kinds.
    pub branches: Option<Along>,
    /// Where.
    pub point: CurvePointRecord,
}

/// What is found on the way to a curve, and along it.
#[derive(Debug, Clone, Copy)]
pub enum CurveFinding<'a> {
    /// An orbit of the branch from which it starts.
    Orbit(&'a OrbitRecord),
    /// An equilibrium of the branch from which it starts.
    Equilibrium(&'a EquilibriumRecord),
    /// A point of the curve.
    Point(&'a CurvePointRecord),
}
