//! One step of a branch: prediction, correction, and the guards on its angles.

use nalgebra::DVector;

use super::branch::{Before, Branch, Refusal, SHORTENED};
use super::corrector::{Corrected, Failure, bordered, correct};
use super::creep::TINY;
use super::link::{Corner, Link};
use super::point::{Base, Point, unit};
use super::predictor::tangent;
use super::range::Stop;
use super::step::{angles, growth};
use super::{Linearisation, ZeroProblem};
use crate::linear::orientation;

/// Share of a step that failed with which the next one is made.
const SHORTER: f64 = 0.4;
/// Failures at one point after which it is tried in other unknowns.
const PATIENCE: usize = 3;
/// Ever shorter steps in a row that turn too far or do not settle, after which it is a corner.
const CORNER: usize = 5;
/// The share of a step that goes along r from which on a corner is looked for from farther away: along a canard nothing does.
const ALONG: f64 = 1e-3;
/// The step around it, over the smallest one: it hardly shows any more what lies before the corner.
const AROUND: f64 = 100.0;
/// The next one that is tried.
const WIDER: f64 = 10.0;
/// By how much both legs of a corner may pass each other, over the step around it, for nothing else to lie there.
const STRAIGHT: f64 = 5e-3;

/// A solution, the step that led to it, and why there is none beyond.
type Stepped<P> = (
    Corrected<<P as ZeroProblem>::Extra>,
    f64,
    Option<Stop<<P as ZeroProblem>::Error>>,
);

impl<P: ZeroProblem + Clone> Branch<P> {
    /// One prediction and correction with the present step; around a `corner`, to which the branch has come like this, it may turn
    /// at once.
    pub(super) fn attempt(
        &mut self,
        base: &Base<P::Extra>,
        corner: Option<&Base<P::Extra>>,
    ) -> Result<Point<P::Extra>, Refusal<P::Error>> {
        let (accuracy, scale) = (self.settings.accuracy, self.problem.scale());
        let inwards;
        let base = match self.settings.left::<P::Error>(base.r) {
            Some((end, _)) if base.leads_from(end) => {
                inwards = base.turned();
                &inwards
            }
            _ => base,
        };
        let (corrected, length, stop) = self.step_from(base)?;
        let direction = base.tangent.clone();
        let arrives = self.tangent(&corrected, &direction)?;
        let straight = match corner.is_some() {
            true => &arrives,
            false => &direction,
        };
        let bend = self.guard(base, straight, &corrected, &scale)?;
        let factor = growth(&corrected.corrections, bend);
        let comes = corner.unwrap_or(base);
        if self.kept(comes, &corrected.linearisation, &arrives) == Some(-1.0) {
            // It turns round at corners only: between them, another leg is near.
            return Err(turns(comes, corrected.r, &arrives).into());
        }
        let problem = self.problem.clone();
        let r_scale = self.r_scale;
        let before = (problem.clone(), base.clone(), r_scale, length);
        let ends = [(base.z.clone(), base.r), (corrected.z.clone(), corrected.r)];
        let back = base.r == self.settings.from && length > AROUND * self.settings.smallest_step;
        if stop.is_some() {
            first_there(base, corrected.r, &arrives)?;
        } else if back && self.settings.left::<P::Error>(corrected.r).is_some() {
            // From the beginning of its range it has turned, and left the range, within this step.
            return Err(turns(base, corrected.r, &arrives).into());
        }
        let tangents = [direction, arrives.clone()];
        let comes = corner.map(|comes| &comes.tangent);
        let mut link = Link::new(problem, ends, tangents, r_scale, accuracy).around(comes);
        let crooked = |corner: Corner| corner.missed > STRAIGHT;
        if link.corner([0.0, 1.0]).is_some_and(crooked) {
            return Err(turns(base, corrected.r, &arrives).into());
        }
        let accepted = self.accept(corrected, arrives);
        // What the problem fixed for the new point does not fit the old one.
        let point = accepted.inspect_err(|_| self.problem.clone_from(&link.problem))?;
        self.link = Some(link);
        self.before = Some(before);
        self.creep.step(length);
        self.step = (self.step * factor).min(self.settings.largest_step);
        self.stop = stop;
        Ok(point)
    }

    /// The solution a step along the tangent, or at the end of the range if that is nearer; the step, and what it ends.
    fn step_from(&mut self, base: &Base<P::Extra>) -> Result<Stepped<P>, Failure<P::Error>> {
        let accuracy = self.settings.accuracy;
        let (n, scale) = (base.z.len(), self.problem.scale());
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
        Ok((corrected, length, end.map(|(_, stop)| stop)))
    }

    /// The next point, by ever shorter steps; `None` where none is short enough.
    pub(super) fn shorter_steps(&mut self) -> Option<Point<P::Extra>> {
        let mut base = self.point.clone()?;
        let (step, smallest) = (self.step, self.settings.smallest_step);
        let (mut failures, mut turns, mut trial) = (0, 0, 0);
        loop {
            let (ends, stop) = match self.attempt(&base, None) {
                Ok(point) => {
                    let tiny = |before: &Before<P>| before.3 < TINY;
                    self.turned &= self.before.as_ref().is_some_and(tiny);
                    return Some(point);
                }
                Err(Refusal::Refused(error)) => (P::ends(&error), Stop::Refused(error)),
                Err(Refusal::Retry(Failure::Evaluation(why))) if !P::ends(&why) => {
                    (false, Stop::Refused(why))
                }
                Err(Refusal::Retry(failure)) => (false, Stop::StepTooSmall(failure)),
            };
            failures += 1;
            // Where it is smooth, the shorter a step the straighter it is, and Newton's method settles.
            let kinked = matches!(&stop, Stop::StepTooSmall(failure) if failure.misses());
            turns = if kinked { turns + 1 } else { 0 };
            let last = SHORTER * self.step < smallest;
            if !ends && (failures % PATIENCE == 0 || last) {
                if let Some(moved) = self.elsewhere(&base, trial) {
                    base = moved;
                    self.step = step.max(SHORTENED * smallest);
                }
                trial += 1;
            }
            self.step *= SHORTER;
            let short = !ends && self.step < smallest;
            let along = base.tangent[base.z.len()].abs() > ALONG;
            if short && along && turns == failures && turns < CORNER {
                // The steps before were short already: longer ones tell whether it is a corner.
                self.step = SHORTENED * smallest;
            }
            if ends || self.step < smallest {
                self.corner = (turns >= CORNER).then(|| (base, stop.clone()));
                self.stop = Some(stop);
                return None;
            }
        }
    }

    /// The point just beyond a corner, from which the branch goes on straight; `None` if there is none.
    pub(super) fn around(
        &mut self,
        base: &Base<P::Extra>,
        stop: Stop<P::Error>,
    ) -> Option<Point<P::Extra>> {
        // Where it turns by more than a right angle, nothing lies straight ahead.
        let straight = |_: &mut Self| Some(base.clone());
        let found = self.wider(base, straight);
        let found = found.or_else(|| self.wider(base, |branch| branch.bent(base)));
        if found.is_none() {
            self.stop = Some(stop);
        }
        found
    }

    /// The point to which a step leads from where `base` says, not too far for one around a corner.
    fn wider(
        &mut self,
        base: &Base<P::Extra>,
        onwards: impl Fn(&mut Self) -> Option<Base<P::Extra>>,
    ) -> Option<Point<P::Extra>> {
        self.step = AROUND * self.settings.smallest_step;
        // At a loose accuracy, the nearest ones do not tell where it goes.
        while self.step <= TINY {
            if let Some(onwards) = onwards(self)
                && let Ok(found) = self.attempt(&onwards, Some(base))
            {
                (self.turned, self.step) = (true, TINY);
                return Some(found);
            }
            self.step *= WIDER;
        }
        None
    }

    /// Where the branch goes beyond a corner that is nearer than the step.
    fn bent(&mut self, base: &Base<P::Extra>) -> Option<Base<P::Extra>> {
        let (n, scale, r_scale) = (base.z.len(), self.problem.scale(), self.r_scale);
        let way = self.step * &base.tangent;
        let z = &base.z + way.rows(0, n).component_mul(&scale);
        let beyond = self.problem.evaluate(&z, base.r + way[n] * r_scale).ok()?;
        let turned = tangent(&beyond, &scale, r_scale, &base.tangent)?;
        Some(Base {
            tangent: turned * self.kept(base, &beyond, &base.tangent)?,
            ..base.clone()
        })
    }

    /// Whether a branch on which other equations take over after `base` goes on to this side there, or to the other one: 1 or -1.
    /// Those that are continuous keep their orientation (E. L. Allgower, K. Georg, Introduction to Numerical Continuation Methods,
    /// SIAM 2003, chapter 12).
    fn kept(
        &self,
        base: &Base<P::Extra>,
        beyond: &Linearisation<P::Extra>,
        along: &DVector<f64>,
    ) -> Option<f64> {
        let before = &base.linearisation;
        let (told, other) = (&before.extra, &beyond.extra);
        if P::same_piece(told, other) || !P::continuous(told, other) {
            return None;
        }
        let (scale, r_scale) = (self.problem.scale(), self.r_scale);
        let side = |piece, along| orientation(&bordered(piece, &scale, r_scale, along));
        Some(side(before, &base.tangent)? * side(beyond, along)?)
    }

    fn guard(
        &self,
        base: &Base<P::Extra>,
        tangent: &DVector<f64>,
        corrected: &Corrected<P::Extra>,
        scale: &DVector<f64>,
    ) -> Result<f64, Failure<P::Error>> {
        let n = base.z.len();
        let mut chord = DVector::zeros(n + 1);
        chord
            .rows_mut(0, n)
            .copy_from(&(&corrected.z - &base.z).component_div(scale));
        chord[n] = (corrected.r - base.r) / self.r_scale;
        let (beta_1, beta_2) = angles(tangent, &chord);
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

/// Whether a step to an end of the range comes to where the branch reaches it first: there it goes on outwards, and where it
/// does not it has been outside.
fn first_there<X: Clone, E>(
    base: &Base<X>,
    r: f64,
    arrives: &DVector<f64>,
) -> Result<(), Failure<E>> {
    let outwards = arrives[base.z.len()] * (r - base.r);
    if outwards >= 0.0 {
        return Ok(());
    }
    Err(turns(base, r, arrives))
}

/// The branch turns too far on a step to r.
fn turns<X, E>(base: &Base<X>, r: f64, arrives: &DVector<f64>) -> Failure<E> {
    let (beta_1, beta_2) = angles(&base.tangent, arrives);
    Failure::Angle { beta_1, beta_2, r }
}
