//! One solution of a branch in other unknowns: begun at another place of it, or divided otherwise.

use std::sync::Arc;

use nalgebra::DVector;

use super::ZeroProblem;
use super::branch::Branch;
use super::corrector::{Corrected, Failure, correct};
use super::point::{Base, unit};

/// Unknowns of one solution, begun at another place of it, are corrected by no more than this.
const SAME: f64 = 1e-2;
/// Share of the tangent that goes along r below which unknowns are not sought at r: many are nearly solutions there.
const STEEP: f64 = 0.1;

impl<P: ZeroProblem + Clone> Branch<P> {
    /// The solution near these unknowns, which are its own but for their errors, at r, or where that hardly changes along this
    /// part of the tangent, across it; `None` if Newton leads to another.
    pub(super) fn same(
        &mut self,
        z: DVector<f64>,
        r: f64,
        lasting: &DVector<f64>,
    ) -> Result<Option<Corrected<P::Extra>>, Failure<P::Error>> {
        let (n, accuracy) = (z.len(), self.settings.accuracy);
        let ends = [self.settings.from, self.settings.to];
        let steep = lasting[n].abs() < STEEP * lasting.norm() && !ends.contains(&r);
        let normal = if steep { lasting.normalize() } else { unit(n) };
        let found = correct(
            &mut self.problem,
            z.clone(),
            r,
            &normal,
            self.r_scale,
            accuracy,
        )?;
        let off = (&found.z - z).component_div(&self.problem.scale());
        Ok((off.norm() <= SAME).then_some(found))
    }

    /// The same point in other unknowns, if the problem knows any: from there a step may succeed.
    pub(super) fn elsewhere(
        &mut self,
        base: &Base<P::Extra>,
        trial: usize,
    ) -> Option<Base<P::Extra>> {
        let before = self.problem.clone();
        let moved = self.other_unknowns(base, trial);
        if moved.is_none() {
            self.problem = before;
        }
        moved
    }

    fn other_unknowns(&mut self, base: &Base<P::Extra>, trial: usize) -> Option<Base<P::Extra>> {
        let z = self.problem.elsewhere(base.r, trial)?;
        let lasting = self.problem.lasting(&base.tangent).try_normalize(0.0)?;
        let found = self.same(z, base.r, &lasting).ok()??;
        // Next to a corner, the other leg lies as near.
        if !P::as_eventful(&base.linearisation.extra, &found.linearisation.extra) {
            return None;
        }
        let tangent = self.tangent(&found, &lasting).ok()?;
        Some(Base {
            z: found.z,
            r: found.r,
            tangent,
            linearisation: Arc::new(found.linearisation),
        })
    }
}
