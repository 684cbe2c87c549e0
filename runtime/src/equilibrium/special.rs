//! Points of a branch of equilibria, and what is looked for on it.

use nalgebra::{DMatrix, DVector};

use super::Spectrum;
use crate::bifurcation::Growths;
use crate::continuation::{Kind, Monitor, Verdict, Watched, changes};

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
    /// Of each contact that slides, presses or bears, see [`Flow::margins`](crate::motion::Flow::margins).
    pub margins: Vec<(usize, f64)>,
    /// The tangent of the branch in the units of (state, r).
    pub way: DVector<f64>,
    /// What its branch measures r in.
    pub r_scale: f64,
    /// r-component of the unit tangent: changes sign at a fold.
    pub(super) slope: f64,
    /// Sign of the product of all eigenvalues.
    pub(super) determinant: f64,
    /// Number of the eigenvalue for which it is special.
    pub(super) critical: Option<usize>,
}

impl EquilibriumPoint {
    /// The least of these margins, and the number of its contact.
    #[must_use]
    pub fn margin(&self) -> Option<(usize, f64)> {
        let margins = self.margins.iter().copied();
        margins.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// |Im λ| of the pair for which it is special, a Hopf point or flutter; `None` if it is neither.
    #[must_use]
    pub fn frequency(&self) -> Option<f64> {
        let critical = self.spectrum.growths.get(self.critical?)?;
        (critical.turn != 0.0).then_some(critical.turn.abs())
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

    fn r_scale(&self) -> f64 {
        self.r_scale
    }

    fn slope(&self) -> f64 {
        self.slope
    }

    fn unstable(&self) -> usize {
        self.spectrum.unstable
    }

    fn marginal(&self) -> Option<usize> {
        Some(self.spectrum.growths.marginal())
    }

    fn inherit(&mut self, before: &Self) {
        self.spectrum.growths.inherit(&before.spectrum.growths);
    }
}

/// Folds, branch points, Hopf points and flutter among this many eigenvalues, and where a contact no longer slides as it
/// did.
pub(super) fn monitors<'a>(eigenvalues: usize) -> Vec<Monitor<'a, EquilibriumPoint>> {
    type Point = EquilibriumPoint;
    let boundary = |point: &Point| point.margin().map_or(f64::INFINITY, |(_, margin)| margin);
    let mut named = vec![
        // At a sharp corner the tangent alone may point backwards, but no eigenvalue passes zero.
        Monitor::new(Kind::Fold, Point::slope).only_if(passes),
        Monitor::new(Kind::BranchPoint, |point: &Point| point.determinant)
            .only_if(|ends| !turns(ends))
            .known_to(|point| point.state.len() as f64 * f64::EPSILON),
        Monitor::new(Kind::BoundaryEquilibrium, boundary)
            .judged(|_, _| Some(Verdict::Last(Kind::BoundaryEquilibrium))),
    ];
    for k in 0..eigenvalues {
        named.push(crossing(k).marked(move |point| point.critical = Some(k)));
        named.push(collision(k).marked(move |point| point.critical = Some(k)));
        named.push(divergence(k));
    }
    named
}

/// Where the real part of eigenvalue k passes zero: a Hopf point, or a branch point at which, by symmetry, two real
/// ones do. A single real one is seen by the determinant.
fn crossing<'a>(k: usize) -> Monitor<'a, EquilibriumPoint> {
    let rate = move |point: &EquilibriumPoint| point.spectrum.growths.crossing(k);
    Monitor::new(Kind::Hopf, rate)
        .known_to(move |point| error(point, k))
        .only_if(move |ends| {
            let growths = ends.map(growths);
            let may = || Growths::may_turn(growths, k) || !passes(ends);
            Growths::may_cross(growths, k) && may()
        })
        .judged(move |ends, at| {
            let all = growths(at);
            match all.get(k)?.turn {
                0.0 if all.is_double(k) && !passes(ends) => {
                    Some(Verdict::Special(Kind::BranchPoint))
                }
                0.0 => None,
                _ => Some(Verdict::Special(Kind::Hopf)),
            }
        })
}

/// Where eigenvalue k and another one collide on the imaginary axis and leave it.
fn collision<'a>(k: usize) -> Monitor<'a, EquilibriumPoint> {
    let distance = move |point: &EquilibriumPoint| point.spectrum.growths.collision(k);
    Monitor::new(Kind::Flutter, distance)
        .only_if(move |ends| Growths::may_collide(ends.map(growths), k))
        .known_to(move |point| (4.0 * turn(point, k) * error(point, k)).powi(2))
}

/// Where, by symmetry, an even number of marginal pairs becomes real: that of an odd number is seen by the determinant.
fn divergence<'a>(k: usize) -> Monitor<'a, EquilibriumPoint> {
    let square = move |point: &EquilibriumPoint| point.spectrum.growths.divergence(k);
    Monitor::new(Kind::BranchPoint, square)
        .only_if(move |ends| Growths::may_diverge(ends.map(growths), k) && !passes(ends))
        .known_to(move |point| error(point, k).powi(2))
}

fn growths(point: &EquilibriumPoint) -> &Growths {
    &point.spectrum.growths
}

/// To what the rate of eigenvalue k is known.
fn error(point: &EquilibriumPoint, k: usize) -> f64 {
    growths(point).get(k).map_or(0.0, |one| one.error)
}

fn turn(point: &EquilibriumPoint, k: usize) -> f64 {
    growths(point).get(k).map_or(0.0, |one| one.turn)
}

/// Whether an odd number of eigenvalues passes zero.
fn passes([from, to]: [&EquilibriumPoint; 2]) -> bool {
    changes(from.determinant, to.determinant)
}

/// Whether the branch turns.
pub(super) fn turns(ends: [&EquilibriumPoint; 2]) -> bool {
    changes(ends[0].slope, ends[1].slope) && passes(ends)
}
