//! A branch of zeros, followed point by point.

use std::sync::Arc;

use nalgebra::DVector;

use super::ZeroProblem;
use super::corrector::{Corrected, Failure, correct};
use super::creep::{Creep, STILL};
use super::link::Link;
use super::measure;
use super::point::{Base, Point, rescaled, unit};
use super::predictor::tangent;
use super::range::{Corner, Settings, Stop};

/// A branch under way; an iterator over its points.
#[derive(Debug)]
pub struct Branch<P: ZeroProblem> {
    /// The problem, as the branch has left it.
    pub problem: P,
    pub(super) settings: Settings,
    pub(super) r_scale: f64,
    pub(super) point: Option<Base<P::Extra>>,
    pub(super) link: Option<Link<P>>,
    pub(super) before: Option<Before<P>>,
    pub(super) step: f64,
    pub(super) count: usize,
    pub(super) creep: Creep,
    /// Where it turns however short the step is, and whether it has just done so.
    pub(super) corner: Option<Corner<P::Extra, P::Error>>,
    pub(super) turned: bool,
    pub(super) stop: Option<Stop<P::Error>>,
}

/// Problem, point, magnitude of r and step before the last step.
pub(super) type Before<P> = (P, Base<<P as ZeroProblem>::Extra>, f64, f64);

/// Share of a step that was taken back with which the next one begins.
const RETRACTED: f64 = 0.25;
/// A step that may be shortened often enough to tell a corner, over the smallest one.
pub(super) const SHORTENED: f64 = 1e3;

/// Why a step was not made.
pub(super) enum Refusal<E> {
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
        let r = settings.from;
        Self::set_out(
            problem,
            (z, r),
            (&direction, measure::own_scale(r)),
            settings,
        )
    }

    /// Converges across `direction` (scaled, r last, in this magnitude) from (z, r) and gives the first point; the
    /// branch goes on to the side of `direction`, between the ends of the settings.
    ///
    /// # Errors
    /// The first point could not be found.
    pub fn set_out(
        mut problem: P,
        (z, r): (DVector<f64>, f64),
        (direction, r_scale): (&DVector<f64>, f64),
        settings: Settings,
    ) -> Result<Started<P>, Failure<P::Error>> {
        let corrected = correct(&mut problem, z, r, direction, r_scale, settings.accuracy)?;
        let mut branch = Self {
            problem,
            settings,
            r_scale,
            point: None,
            link: None,
            before: None,
            creep: Creep::none(),
            corner: None,
            turned: false,
            step: settings.first_step,
            stop: (settings.to == settings.from).then_some(Stop::ReachedEnd),
            count: 0,
        };
        let tangent = branch.tangent(&corrected, direction)?;
        let point = branch
            .accept(corrected, tangent)
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

    /// How it is followed.
    #[must_use]
    pub fn settings(&self) -> Settings {
        self.settings
    }

    /// The usual magnitude of r: steps are measured in it.
    #[must_use]
    pub fn r_scale(&self) -> f64 {
        self.r_scale
    }

    /// The step to the last point; `None` at the first.
    #[must_use]
    pub fn link(&self) -> Option<&Link<P>> {
        self.link.as_ref()
    }

    /// Takes the last step back, so that the next one is made from the point before it and is much
    /// shorter; `false` if it was as short as may be, or if it has been taken back already.
    pub fn retract(&mut self) -> bool {
        let Some((problem, point, r_scale, step)) = self.before.take() else {
            return false;
        };
        let step = RETRACTED * step;
        if step < self.settings.smallest_step {
            return false;
        }
        self.problem = problem;
        self.r_scale = r_scale;
        self.point = Some(point);
        self.step = step;
        self.count -= 1;
        self.link = None;
        self.stop = None;
        true
    }

    /// The point at the end of its range, as the first one, if it begins beyond it; `None` if it does not, or none is found.
    pub(super) fn back_in_range(&mut self) -> Option<Point<P::Extra>> {
        let base = self.point.as_ref()?;
        self.settings.left::<P::Error>(base.r)?;
        let end = self.next()?;
        (self.link, self.before) = (None, None);
        Some(end)
    }

    /// Tries once more where no step was small enough, or too many are tiny, with one as long as the last that was made, or so
    /// long that a corner is told.
    pub(super) fn resume(&mut self) {
        let last = self.before.as_ref().map(|(_, _, _, length)| *length);
        let least = SHORTENED * self.settings.smallest_step;
        self.step = last.map_or(self.settings.first_step, |last| last.max(least));
        (self.stop, self.corner) = (None, None);
        self.creep.is_sharp();
    }

    /// Whether it may go on around a corner, where it stopped.
    pub(super) fn turn(&mut self) -> bool {
        let turns = self.corner.is_some() && !self.turned;
        if turns {
            self.stop = None;
        }
        turns
    }

    /// Goes on from a corrected point with its tangent.
    pub(super) fn accept(
        &mut self,
        mut corrected: Corrected<P::Extra>,
        tangent: DVector<f64>,
    ) -> Result<Point<P::Extra>, Refusal<P::Error>> {
        let mut newton = corrected.corrections.len();
        let (before, kept) = (self.problem.scale(), self.problem.clone());
        let moved = self
            .problem
            .accept(&corrected.z, corrected.r, &corrected.linearisation.extra)
            .map_err(Refusal::Refused)?;
        let mut tangent = match moved {
            Some(_) => tangent,
            None => rescaled(tangent, &before.component_div(&self.problem.scale()), 1.0),
        };
        if let Some(z) = moved {
            let lasting = self.problem.lasting(&tangent);
            match self.same(z, corrected.r, &lasting)? {
                Some(found) => {
                    corrected = found;
                    newton += corrected.corrections.len();
                    tangent = self.tangent(&corrected, &lasting)?;
                }
                None => self.problem = kept,
            }
        }
        let Corrected {
            z,
            r,
            linearisation,
            residual,
            ..
        } = corrected;
        let range = [self.settings.from, self.settings.to];
        let r_scale = measure::at(r, &tangent, self.r_scale, range);
        let same = DVector::from_element(z.len(), 1.0);
        tangent = rescaled(tangent, &same, self.r_scale / r_scale);
        self.r_scale = r_scale;
        let stands = |before: &Base<P::Extra>| (r - before.r).abs() <= STILL * r_scale;
        let still = self.point.as_ref().is_some_and(stands);
        self.creep.stand(still);
        self.point = Some(Base {
            z: z.clone(),
            r,
            tangent: tangent.clone(),
            linearisation: Arc::new(linearisation.clone()),
        });
        self.count += 1;
        Ok(Point {
            z,
            r,
            extra: linearisation.extra,
            residual,
            tangent,
            r_scale,
            newton: newton as u64,
        })
    }

    pub(super) fn tangent(
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
        if let Some(stop) = self.creep.stop() {
            self.stop = Some(stop);
            return None;
        }
        match self.corner.take() {
            Some((base, stop)) => self.around(&base, stop),
            None => self.shorter_steps(),
        }
    }
}

#[cfg(test)]
mod tests;
