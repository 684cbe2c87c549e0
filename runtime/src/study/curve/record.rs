//! What is asked and reported of a curve.

use nalgebra::Complex;
use serde::Serialize;

use crate::continuation::Kind;
use crate::field::Work;
use crate::study::branch::BranchRecord;
use crate::study::ended::Ended;
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

/// What came of a curve.
#[derive(Debug, Clone, PartialEq)]
pub enum Curved {
    /// It was followed.
    Followed(Box<CurveRecord>),
    /// The branch of the special point was interrupted before the curve began; as far as it came.
    Interrupted(Box<BranchRecord>),
}

impl Curved {
    /// The curve, if there is one.
    #[must_use]
    pub fn followed(self) -> Option<CurveRecord> {
        match self {
            Self::Followed(curve) => Some(*curve),
            Self::Interrupted(_) => None,
        }
    }
}

/// A curve as it is reported, whatever model it belongs to.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveRecord {
    /// The branch from which it starts.
    pub branch: BranchRecord,
    /// The first design variable and its range.
    pub along: Along,
    /// The second.
    pub and: Along,
    /// The label of the special point from which it starts.
    pub of: String,
    /// What it is a curve of: `fold`, `flip`, `torus`, `grazing-sliding`.
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

/// A special orbit.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CurvePointRecord {
    /// The first design variable, in the user's own values.
    #[serde(skip)]
    pub p: f64,
    /// The second.
    #[serde(skip)]
    pub q: f64,
    /// Its period.
    pub period: f64,
    /// A state of the orbit: where the first state is least, or where the orbit grazes.
    pub state: Vec<f64>,
    /// Its multipliers; none where it grazes.
    pub multipliers: Vec<Complex<f64>>,
    /// Norm of the residual of its equations.
    pub residual: f64,
    /// The condition that makes it special, as it was met.
    pub test: f64,
}

/// A point of codimension two.
#[derive(Debug, Clone, PartialEq)]
pub struct SpecialCurvePoint {
    /// What: `cusp`, `isola-centre`, `fold-flip`, `resonance-1-2`, ...
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
    /// A point of the curve.
    Point(&'a CurvePointRecord),
}
