//! A branch of zeros, followed point by point.

use nalgebra::DVector;

use super::ZeroProblem;
use super::corrector::{Corrected, Failure, correct};
use super::link::Link;
use super::predictor::tangent;
use super::range::{Settings, Stop};
use super::step::{angles, growth};

/// An accepted point of a branch.
#[derive(Debug, Clone)]
pub struct Point<Extra> {
    /// Unknowns.
    pub z: DVector<f64>,
    /// Design variable.
    pub r: f64,
    /// What the problem says of it.
    pub extra: Extra,
    /// Norm of the residual.
    pub residual: f64,
    /// Unit tangent in scaled coordinates, r last: that component changes sign at a fold.
    pub tangent: DVector<f64>,
    /// Newton iterations spent.
    pub newton: u64,
}

/// A branch under way; an iterator over its points.
#[derive(Debug)]
pub struct Branch<P: ZeroProblem> {
    /// The problem, as the branch has left it.
    pub problem: P,
    settings: Settings,
    r_scale: f64,
    point: Option<Base>,
    link: Option<Link<P>>,
    /// Problem, point and step before the last step.
    before: Option<(P, Base, f64)>,
    step: f64,
    count: usize,
    /// Steps in a row that were tiny.
    tiny: usize,
    stop: Option<Stop<P::Error>>,
}

/// Share of a step that was taken back with which the next one begins.
const RETRACTED: f64 = 0.25;
/// Steps shorter than this, in scaled coordinates, are tiny: so many in a row lead nowhere.
const TINY: f64 = 1e-4;
const CREEPING: usize = 300;

/// Failures at one point after which it is tried in other unknowns.
const PATIENCE: usize = 3;

/// Why a step was not made.
enum Refusal<E> {
    /// A smaller one may succeed.
    Retry(Failure<E>),
    /// The problem ends the branch here.
    Refused(E),
}

impl<E> From<Failure<E>> for Refusal<E> {
    fn from(failure: Failure<E>) -> Self {
        Self::Retry(failure)
    }
}

/// The point from which the next step is made, in unscaled coordinates.
#[derive(Debug, Clone)]
struct Base {
    z: DVector<f64>,
    r: f64,
    tangent: DVector<f64>,
}

/// A branch and its first point.
pub type Started<P> = (Branch<P>, Point<<P as ZeroProblem>::Extra>);

impl<P: ZeroProblem + Clone> Branch<P> {
    /// Converges on (z, r = from) and gives the first point.
    ///
    /// # Errors
    /// The first point could not be found.
    pub fn start(
        problem: P,
        z: DVector<f64>,
        settings: Settings,
    ) -> Result<Started<P>, Failure<P::Error>> {
        let mut direction = unit(z.len());
        if settings.to < settings.from {
            direction.neg_mut();
        }
        Self::set_out(problem, (z, settings.from), &direction, settings)
    }

    /// Converges across `direction` (scaled, r last) from (z, r) and gives the first point; the branch
    /// goes on to the side of `direction`, between the ends of the settings.
    ///
    /// # Errors
    /// The first point could not be found.
    pub fn set_out(
        mut problem: P,
        (z, r): (DVector<f64>, f64),
        direction: &DVector<f64>,
        settings: Settings,
    ) -> Result<Started<P>, Failure<P::Error>> {
        let span = settings.to - settings.from;
        let r_scale = if span == 0.0 { 1.0 } else { span.abs() };
        let corrected = correct(&mut problem, z, r, direction, r_scale, settings.accuracy)?;
        let mut branch = Self {
            problem,
            settings,
            r_scale,
            point: None,
            link: None,
            before: None,
            tiny: 0,
            step: settings.first_step,
            stop: (span == 0.0).then_some(Stop::ReachedEnd),
            count: 0,
        };
        let point = branch
            .accept(corrected, direction)
            .map_err(|stop| match stop {
                Refusal::Retry(failure) => failure,
                Refusal::Refused(error) => Failure::Evaluation(error),
            })?;
        Ok((branch, point))
    }

    /// Why the branch ended; `None` while it goes on.
    #[must_use]
    pub fn stop(&self) -> Option<&Stop<P::Error>> {
        self.stop.as_ref()
    }

    /// The step to the last point; `None` at the first.
    #[must_use]
    pub fn link(&self) -> Option<&Link<P>> {
        self.link.as_ref()
    }

    /// Takes the last step back, so that the next one is made from the point before it and is much
    /// shorter; `false` if it was as short as may be, or if it has been taken back already.
    pub fn retract(&mut self) -> bool {
        let Some((problem, point, step)) = self.before.take() else {
            return false;
        };
        let step = RETRACTED * step;
        if step < self.settings.smallest_step {
            return false;
        }
        self.problem = problem;
        self.point = Some(point);
        self.step = step;
        self.count -= 1;
        self.link = None;
        self.stop = None;
        true
    }

    fn accept(
        &mut self,
        corrected: Corrected<P::Extra>,
        direction: &DVector<f64>,
    ) -> Result<Point<P::Extra>, Refusal<P::Error>> {
        let mut corrected = corrected;
        let mut newton = corrected.corrections.len();
        let before = self.problem.scale();
        let tangent = self.tangent(&corrected, direction)?;
        let moved = self
            .problem
            .accept(&corrected.z, corrected.r, &corrected.linearisation.extra)
            .map_err(Refusal::Refused)?;
        let mut tangent = rescaled(tangent, &before.component_div(&self.problem.scale()));
        if let Some(z) = moved {
            let (r, n) = (corrected.r, z.len());
            corrected = correct(
                &mut self.problem,
                z,
                r,
                &unit(n),
                self.r_scale,
                self.settings.accuracy,
            )?;
            newton += corrected.corrections.len();
            tangent = self.tangent(&corrected, &self.problem.lasting(&tangent))?;
        }
        let Corrected {
            z,
            r,
            linearisation,
            residual,
            ..
        } = corrected;
        self.point = Some(Base {
            z: z.clone(),
            r,
            tangent: tangent.clone(),
        });
        self.count += 1;
        Ok(Point {
            z,
            r,
            extra: linearisation.extra,
            residual,
            tangent,
            newton: newton as u64,
        })
    }

    fn tangent(
        &self,
        corrected: &Corrected<P::Extra>,
        direction: &DVector<f64>,
    ) -> Result<DVector<f64>, Failure<P::Error>> {
        tangent(
            &corrected.linearisation,
            &self.problem.scale(),
            self.r_scale,
            direction,
        )
        .ok_or(Failure::Singular { r: corrected.r })
    }

    /// One prediction and correction with the present step.
    fn attempt(&mut self, base: &Base) -> Result<Point<P::Extra>, Refusal<P::Error>> {
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
        let before = (problem.clone(), base.clone(), length);
        let ends = [(base.z.clone(), base.r), (corrected.z.clone(), corrected.r)];
        let point = self.accept(corrected, &direction)?;
        self.link = Some(Link::new(problem, ends, self.r_scale, accuracy));
        self.before = Some(before);
        self.tiny = if length < TINY { self.tiny + 1 } else { 0 };
        self.step = (self.step * factor).min(self.settings.largest_step);
        self.stop = end.map(|(_, stop)| stop);
        Ok(point)
    }

    /// The same point in other unknowns, if the problem knows any: from there a step may succeed.
    fn elsewhere(&mut self, base: &Base, trial: usize) -> Option<Base> {
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
        let Settings { accuracy, .. } = self.settings;
        let normal = unit(z.len());
        let found = correct(
            &mut self.problem,
            z,
            base.r,
            &normal,
            self.r_scale,
            accuracy,
        )
        .ok()?;
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

/// A tangent in coordinates that are stretched by `ratio`, r left as it is.
fn rescaled(mut tangent: DVector<f64>, ratio: &DVector<f64>) -> DVector<f64> {
    tangent.rows_mut(0, ratio.len()).component_mul_assign(ratio);
    tangent.normalize()
}

fn unit(n: usize) -> DVector<f64> {
    let mut normal = DVector::zeros(n + 1);
    normal[n] = 1.0;
    normal
}

impl<P: ZeroProblem + Clone> Iterator for Branch<P> {
    type Item = Point<P::Extra>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.stop.is_some() {
            return None;
        }
        if self.count >= self.settings.points {
            self.stop = Some(Stop::TooManyPoints);
            return None;
        }
        if self.tiny > CREEPING {
            self.stop = Some(Stop::Creeping(TINY));
            return None;
        }
        let mut base = self.point.clone()?;
        let (step, mut failures) = (self.step, 0);
        loop {
            match self.attempt(&base) {
                Ok(point) => return Some(point),
                Err(Refusal::Refused(error)) => {
                    self.stop = Some(Stop::Refused(error));
                    return None;
                }
                Err(Refusal::Retry(failure)) => {
                    failures += 1;
                    if failures % PATIENCE == 0
                        && let Some(moved) = self.elsewhere(&base, failures / PATIENCE - 1)
                    {
                        base = moved;
                        self.step = step;
                    }
                    self.step *= 0.4;
                    if self.step < self.settings.smallest_step {
                        self.stop = Some(Stop::StepTooSmall(failure));
                        return None;
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests;
