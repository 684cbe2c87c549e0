//! What lies between two neighbouring points of a branch.

use nalgebra::DVector;

use super::corrector::{Failure, bordered, correct};
use super::point::Point;
use super::predictor::tangent;
use super::{Corrected, Linearisation, ZeroProblem};
use crate::linear::solved;

/// Distance from the chord, relative to its length, beyond which a point lies on another branch.
const OFF: f64 = 0.5;
/// Distance from the branch, relative to the length of the step, up to which a point beside it tells about that on it.
const BESIDE: f64 = 0.01;
/// Distance of the cubic from the branch, relative to the length of the step, beyond which the step may have leapt from one leg
/// of a bend to another.
const LEAPT: f64 = 0.05;
/// Corrections below this are rounding errors.
const FINEST: f64 = 1e-14;

/// One step of a branch: its ends, and the problem as it was when the step was made.
#[derive(Debug, Clone)]
pub struct Link<P> {
    /// The problem, with what it fixed between its ends.
    pub problem: P,
    ends: [(DVector<f64>, f64); 2],
    /// Unit vector from end to end, in scaled coordinates with r last.
    chord: DVector<f64>,
    length: f64,
    /// Unit tangents at both ends.
    tangents: [DVector<f64>; 2],
    /// The tangent with which the branch came, where it turned at once behind the first end.
    comes: Option<DVector<f64>>,
    r_scale: f64,
    accuracy: f64,
    /// Share of the accuracy to which points between are found.
    share: f64,
    /// The largest distance of the cubic from the branch that was met, relative to the length of the step.
    off: f64,
}

/// A point, and the tangent of the branch there.
type Leg = ((DVector<f64>, f64), DVector<f64>);

/// Where a branch turns at once between two of its points.
#[derive(Debug, Clone, Copy)]
pub(super) struct Corner {
    pub(super) r: f64,
    /// Error of r for how far its legs pass each other.
    pub(super) error: f64,
    /// How far they do, over the distance of the points.
    pub(super) missed: f64,
}

impl<P: ZeroProblem> Link<P> {
    pub(super) fn new(
        problem: P,
        ends: [(DVector<f64>, f64); 2],
        tangents: [DVector<f64>; 2],
        r_scale: f64,
        accuracy: f64,
    ) -> Self {
        let [from, to] = &ends;
        let chord = scaled(&problem.scale(), r_scale, &(&to.0 - &from.0), to.1 - from.1);
        let length = chord.norm();
        Self {
            problem,
            chord: chord / length,
            length,
            ends,
            tangents,
            comes: None,
            r_scale,
            accuracy,
            share: 1.0,
            off: 0.0,
        }
    }

    /// The step around a corner to which the branch came with this tangent.
    pub(super) fn around(self, comes: Option<&DVector<f64>>) -> Self {
        let comes = comes.cloned();
        Self { comes, ..self }
    }

    /// Finds points between its ends to this share of its accuracy.
    pub(super) fn sharpen(&mut self, share: f64) {
        self.share = share;
    }

    /// Unit vector from end to end, in scaled coordinates with r last.
    #[must_use]
    pub fn chord(&self) -> &DVector<f64> {
        &self.chord
    }

    /// The magnitude of r in which steps are measured.
    pub(super) fn r_scale(&self) -> f64 {
        self.r_scale
    }

    /// Distance of its ends, in scaled coordinates.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// The point of the branch in the plane across the chord at this share of it, 0 < share < 1.
    ///
    /// # Errors
    /// The corrector failed, or went to another branch.
    pub fn between(&mut self, share: f64) -> Result<Point<P::Extra>, Failure<P::Error>> {
        let (z, r) = self.on_chord(share);
        // The cubic meets the plane across the chord where the chord itself does.
        let near = self.on_cubic(share).map(|[near, _]| near);
        let near = near.unwrap_or_else(|| (z.clone(), r));
        let found = self.across(near, &self.chord.clone())?;
        let scale = self.problem.scale();
        let off = scaled(&scale, self.r_scale, &(&found.z - z), found.r - r).norm();
        if off > OFF * self.length {
            let beta = (off / self.length).atan();
            return Err(Failure::Angle {
                beta_1: beta,
                beta_2: beta,
                r: found.r,
            });
        }
        Ok(found)
    }

    /// About the point at this share of the way: that of the cubic through both ends along both tangents, corrected only if
    /// it is far from the branch.
    pub(super) fn glance(&mut self, share: f64) -> Option<Point<P::Extra>> {
        let [(z, r), (dz, dr)] = self.on_cubic(share)?;
        let at = self.problem.evaluate(&z, r).ok()?;
        let off = self.off(&at)? / self.length;
        self.off = self.off.max(off);
        if off > BESIDE {
            return self.across((z, r), &self.chord.clone()).ok();
        }
        let tangent = scaled(&self.problem.scale(), self.r_scale, &dz, dr);
        Some(Point {
            residual: at.residual.norm(),
            tangent: tangent.try_normalize(0.0)?,
            r_scale: self.r_scale,
            extra: at.extra,
            newton: 0,
            z,
            r,
        })
    }

    /// Whether it has hardly gone along the branch, as far as its points between tell that were glanced at.
    pub(super) fn leapt(&self) -> bool {
        self.off > LEAPT
    }

    /// How far a point is from the branch, to first order, across the chord.
    fn off(&self, at: &Linearisation<P::Extra>) -> Option<f64> {
        let matrix = bordered(at, &self.problem.scale(), self.r_scale, &self.chord);
        let correction = solved(&matrix, &(-&at.residual).push(0.0))?;
        Some(correction.norm())
    }

    /// The point of the branch at which r has gone this share of its way, 0 < share < 1; where r turns between the ends,
    /// it may be none of those between.
    ///
    /// # Errors
    /// The corrector failed.
    pub fn level(&mut self, share: f64) -> Result<Point<P::Extra>, Failure<P::Error>> {
        let [from, to] = &self.ends;
        let mut normal = DVector::zeros(from.0.len() + 1);
        normal[from.0.len()] = (to.1 - from.1).signum();
        self.across(self.on_chord(share), &normal)
    }

    /// Where legs meet that go straight on from the points at these shares of a step around a corner.
    pub(super) fn corner(&mut self, shares: [f64; 2]) -> Option<Corner> {
        self.comes.as_ref()?;
        let [first, second] = shares.map(|share| self.leg(share));
        let [(from, comes), (to, leaves)] = [first?, second?];
        let way = scaled(
            &self.problem.scale(),
            self.r_scale,
            &(&to.0 - &from.0),
            to.1 - from.1,
        );
        let even = comes.dot(&leaves);
        let apart = 1.0 - even * even;
        let [first, second] = [way.dot(&comes), way.dot(&leaves)];
        let [on, back] = [first - even * second, second - even * first].map(|leg| leg / apart);
        let missed = (&way - &comes * on - leaves * back).norm();
        let corner = Corner {
            r: from.1 + on * comes[comes.len() - 1] * self.r_scale,
            error: missed / apart.sqrt() * self.r_scale,
            missed: missed / way.norm(),
        };
        (corner.r.is_finite() && corner.error.is_finite()).then_some(corner)
    }

    /// The point at this share of the way, the ends with it, and the tangent of the branch on its side.
    fn leg(&mut self, share: f64) -> Option<Leg> {
        if share <= 0.0 {
            return Some((self.ends[0].clone(), self.comes.clone()?));
        }
        if share >= 1.0 {
            return Some((self.ends[1].clone(), self.tangents[1].clone()));
        }
        let Point { z, r, tangent, .. } = self.between(share).ok()?;
        Some(((z, r), tangent))
    }

    /// The point of the chord at this share of it.
    fn on_chord(&self, share: f64) -> (DVector<f64>, f64) {
        let [from, to] = &self.ends;
        let z = &from.0 + (&to.0 - &from.0) * share;
        (z, from.1 + (to.1 - from.1) * share)
    }

    /// The point at this share of the cubic through both ends along both tangents, and its derivatives by the share.
    fn on_cubic(&self, share: f64) -> Option<[(DVector<f64>, f64); 2]> {
        let (s, scale) = (share, self.problem.scale());
        let along = |tangent: &DVector<f64>| tangent * (self.length / tangent.dot(&self.chord));
        let [leaves, arrives] = self.tangents.each_ref().map(along);
        let chord = &self.chord * self.length;
        // Hermite's basis: what the chord and both tangents add.
        let way = &chord * (s * s * (3.0 - 2.0 * s)) + &leaves * (s * (1.0 - s) * (1.0 - s))
            - &arrives * (s * s * (1.0 - s));
        let slope = &chord * (6.0 * s * (1.0 - s))
            + &leaves * ((1.0 - s) * (1.0 - 3.0 * s))
            + &arrives * (s * (3.0 * s - 2.0));
        let n = scale.len();
        let unscaled = |v: DVector<f64>| (v.rows(0, n).component_mul(&scale), v[n] * self.r_scale);
        let (from, finite) = (&self.ends[0], way.iter().all(|x| x.is_finite()));
        let (by, slope) = (unscaled(way), unscaled(slope));
        finite.then(|| [(&from.0 + by.0, from.1 + by.1), slope])
    }

    /// The point of the branch in the plane across `normal` through a point near it.
    fn across(
        &mut self,
        (z, r): (DVector<f64>, f64),
        normal: &DVector<f64>,
    ) -> Result<Point<P::Extra>, Failure<P::Error>> {
        let accuracy = (self.share * self.accuracy).max(FINEST);
        let found = correct(&mut self.problem, z, r, normal, self.r_scale, accuracy)?;
        let scale = self.problem.scale();
        let direction = tangent(&found.linearisation, &scale, self.r_scale, normal)
            .ok_or(Failure::Singular { r: found.r })?;
        let Corrected {
            z,
            r,
            linearisation,
            residual,
            corrections,
        } = found;
        Ok(Point {
            tangent: direction,
            r_scale: self.r_scale,
            z,
            r,
            extra: linearisation.extra,
            residual,
            newton: corrections.len() as u64,
        })
    }
}

fn scaled(scale: &DVector<f64>, r_scale: f64, z: &DVector<f64>, r: f64) -> DVector<f64> {
    let n = z.len();
    DVector::from_fn(
        n + 1,
        |i, _| if i == n { r / r_scale } else { z[i] / scale[i] },
    )
}
