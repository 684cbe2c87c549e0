//! One step of a branch: prediction, correction, and the guards on its angles.

use nalgebra::DVector;

use super::ZeroProblem;
use super::branch::{Branch, Refusal, TINY};
use super::corrector::{Corrected, Failure, correct};
use super::link::Link;
use super::point::{Base, Point, unit};
use super::range::Settings;
use super::step::{angles, growth};

impl<P: ZeroProblem + Clone> Branch<P> {
    /// One prediction and correction with the present step.
    pub(super) fn attempt(&mut self, base: &Base) -> Result<Point<P::Extra>, Refusal<P::Error>> {
        let Settings { accuracy, .. } = self.settings;
        let n = base.z.len();
        let scale = self.problem.scale();
        let mut length = self.step;
        let slope = base.tangent[n] * self.r_scale;
        let mut normal = base.tangent.clone();
        let mut end = self.settings.passed(base.r, base.r + length * slope);
        if let Some((r, _)) = &end {
            length = (r - base.r) / slope;
            normal = unit(n);
        }
        let z = &base.z + length * base.tangent.rows(0, n).component_mul(&scale);
        let r = end.as_ref().map_or(base.r + length * slope, |end| end.0);
        let mut corrected = correct(&mut self.problem, z, r, &normal, self.r_scale, accuracy)?;
        if end.is_none()
            && let Some(passed) = self.settings.passed(base.r, corrected.r)
        {
            // The correction carried r beyond the end: come back to it along the chord.
            let share = (passed.0 - base.r) / (corrected.r - base.r);
            let z = &base.z + (&corrected.z - &base.z) * share;
            let r = passed.0;
            corrected = correct(&mut self.problem, z, r, &unit(n), self.r_scale, accuracy)?;
            end = Some(passed);
        }
        let bend = self.guard(base, &corrected, &scale)?;
        let factor = growth(&corrected.corrections, bend);
        let direction = base.tangent.clone();
        let problem = self.problem.clone();
        let r_scale = self.r_scale;
        let before = (problem.clone(), base.clone(), r_scale, length);
        let ends = [(base.z.clone(), base.r), (corrected.z.clone(), corrected.r)];
        let arrives = self.tangent(&corrected, &direction)?;
        let accepted = self.accept(corrected, arrives.clone());
        // What the problem fixed for the new point does not fit the old one.
        let point = accepted.inspect_err(|_| self.problem.clone_from(&problem))?;
        let tangents = [direction, arrives];
        self.link = Some(Link::new(problem, ends, tangents, r_scale, accuracy));
        self.before = Some(before);
        self.tiny = if length < TINY { self.tiny + 1 } else { 0 };
        self.step = (self.step * factor).min(self.settings.largest_step);
        self.stop = end.map(|(_, stop)| stop);
        Ok(point)
    }

    /// The same point in other unknowns, if the problem knows any: from there a step may succeed.
    pub(super) fn elsewhere(&mut self, base: &Base, trial: usize) -> Option<Base> {
        let before = self.problem.clone();
        let moved = self.other_unknowns(base, trial);
        if moved.is_none() {
            self.problem = before;
        }
        moved
    }

    fn other_unknowns(&mut self, base: &Base, trial: usize) -> Option<Base> {
        let z = self.problem.elsewhere(base.r, trial)?;
        let lasting = self.problem.lasting(&base.tangent).try_normalize(0.0)?;
        let found = self.same(z, base.r).ok()??;
        let tangent = self.tangent(&found, &lasting).ok()?;
        Some(Base {
            z: found.z,
            r: found.r,
            tangent,
        })
    }

    fn guard(
        &self,
        base: &Base,
        corrected: &Corrected<P::Extra>,
        scale: &DVector<f64>,
    ) -> Result<f64, Failure<P::Error>> {
        let n = base.z.len();
        let mut chord = DVector::zeros(n + 1);
        chord
            .rows_mut(0, n)
            .copy_from(&(&corrected.z - &base.z).component_div(scale));
        chord[n] = (corrected.r - base.r) / self.r_scale;
        let (beta_1, beta_2) = angles(&base.tangent, &chord);
        let turned = chord.rows(0, n).norm() > 1e-3 * chord.norm() && beta_2 > self.settings.beta_2;
        if beta_1 > self.settings.beta_1 || turned {
            return Err(Failure::Angle {
                beta_1,
                beta_2,
                r: corrected.r,
            });
        }
        Ok(beta_1)
    }
}
