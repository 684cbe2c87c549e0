//! A branch of zeros, followed point by point.

use nalgebra::DVector;

use super::ZeroProblem;
use super::corrector::{Corrected, Failure, correct};
use super::link::Link;
use super::predictor::tangent;
use super::step::{angles, growth};

/// How a branch is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Where r begins.
    pub from: f64,
    /// Where r shall end.
    pub to: f64,
    /// Corrections at most this, relative to the scale of the unknowns, end an iteration.
    pub accuracy: f64,
    /// First step, as an arclength in scaled coordinates; r is scaled by |to − from|.
    pub first_step: f64,
    /// Smallest step.
    pub smallest_step: f64,
    /// Largest step.
    pub largest_step: f64,
    /// Largest angle between tangent and chord (2.21), rad.
    pub beta_1: f64,
    /// Largest angle between tangent and chord without r (2.22), rad.
    pub beta_2: f64,
    /// Most points.
    pub points: usize,
}

impl Settings {
    /// The usual settings for r from `from` to `to`.
    #[must_use]
    pub fn new(from: f64, to: f64, accuracy: f64) -> Self {
        Self {
            from,
            to,
            accuracy,
            first_step: 0.02,
            smallest_step: 1e-7,
            largest_step: 0.5,
            beta_1: 0.35,
            beta_2: 0.7,
            points: 10_000,
        }
    }
}

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
    /// r-component of the unit tangent in scaled coordinates: changes sign at a fold.
    pub tangent_r: f64,
    /// Newton iterations spent.
    pub newton: u64,
}

/// Why a branch ended.
#[derive(Debug, Clone, PartialEq)]
pub enum Ending<E> {
    /// r reached its end.
    ReachedEnd,
    /// r came back to where it began.
    ReachedStart,
    /// The step fell below the smallest; with the last reason: (2.23).
    StepTooSmall(Failure<E>),
    /// The limit of points.
    TooManyPoints,
    /// The problem says that the branch ends here.
    Refused(E),
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
    step: f64,
    count: usize,
    ending: Option<Ending<P::Error>>,
}

/// Why a step was not made.
enum Stop<E> {
    /// A smaller one may succeed.
    Retry(Failure<E>),
    /// The problem ends the branch here.
    Refused(E),
}

impl<E> From<Failure<E>> for Stop<E> {
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
        mut problem: P,
        z: DVector<f64>,
        settings: Settings,
    ) -> Result<Started<P>, Failure<P::Error>> {
        let span = settings.to - settings.from;
        let r_scale = if span == 0.0 { 1.0 } else { span.abs() };
        let n = z.len();
        let mut normal = DVector::zeros(n + 1);
        normal[n] = if span < 0.0 { -1.0 } else { 1.0 };
        let corrected = correct(
            &mut problem,
            z,
            settings.from,
            &normal,
            r_scale,
            settings.accuracy,
        )?;
        let mut branch = Self {
            problem,
            settings,
            r_scale,
            point: None,
            link: None,
            step: settings.first_step,
            count: 0,
            ending: (span == 0.0).then_some(Ending::ReachedEnd),
        };
        let point = branch
            .accept(corrected, &normal)
            .map_err(|stop| match stop {
                Stop::Retry(failure) => failure,
                Stop::Refused(error) => Failure::Evaluation(error),
            })?;
        Ok((branch, point))
    }

    /// Why the branch ended; `None` while it goes on.
    #[must_use]
    pub fn ending(&self) -> Option<&Ending<P::Error>> {
        self.ending.as_ref()
    }

    /// The step to the last point; `None` at the first.
    #[must_use]
    pub fn link(&self) -> Option<&Link<P>> {
        self.link.as_ref()
    }

    fn accept(
        &mut self,
        corrected: Corrected<P::Extra>,
        direction: &DVector<f64>,
    ) -> Result<Point<P::Extra>, Stop<P::Error>> {
        let mut corrected = corrected;
        let mut newton = corrected.corrections.len();
        let before = self.problem.scale();
        let tangent = self.tangent(&corrected, direction)?;
        let moved = self
            .problem
            .accept(&corrected.z, corrected.r, &corrected.linearisation.extra)
            .map_err(Stop::Refused)?;
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
        let tangent_r = tangent[z.len()];
        self.point = Some(Base {
            z: z.clone(),
            r,
            tangent,
        });
        self.count += 1;
        Ok(Point {
            z,
            r,
            extra: linearisation.extra,
            residual,
            tangent_r,
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
    fn attempt(&mut self, base: &Base) -> Result<Point<P::Extra>, Stop<P::Error>> {
        let Settings {
            to, from, accuracy, ..
        } = self.settings;
        let n = base.z.len();
        let scale = self.problem.scale();
        let towards = |r: f64| (r - to) * (to - from) >= 0.0;
        let mut length = self.step;
        let slope = base.tangent[n] * self.r_scale;
        let mut normal = base.tangent.clone();
        let mut last = towards(base.r + length * slope);
        if last {
            length = (to - base.r) / slope;
            normal = unit(n);
        }
        let predict = |length: f64| -> (DVector<f64>, f64) {
            let z = &base.z + length * base.tangent.rows(0, n).component_mul(&scale);
            (z, base.r + length * slope)
        };
        let (z, r) = predict(length);
        let r = if last { to } else { r };
        let mut corrected = correct(&mut self.problem, z, r, &normal, self.r_scale, accuracy)?;
        if !last && towards(corrected.r) {
            // The correction carried r beyond the end: come back to it along the chord.
            let share = (to - base.r) / (corrected.r - base.r);
            let z = &base.z + (&corrected.z - &base.z) * share;
            corrected = correct(&mut self.problem, z, to, &unit(n), self.r_scale, accuracy)?;
            last = true;
        }
        let bend = self.guard(base, &corrected, &scale)?;
        let factor = growth(&corrected.corrections, bend);
        let direction = base.tangent.clone();
        let problem = self.problem.clone();
        let ends = [(base.z.clone(), base.r), (corrected.z.clone(), corrected.r)];
        let point = self.accept(corrected, &direction)?;
        self.link = Some(Link::new(problem, ends, self.r_scale, accuracy));
        self.step = (self.step * factor).min(self.settings.largest_step);
        if last {
            self.ending = Some(Ending::ReachedEnd);
        }
        Ok(point)
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
        if self.ending.is_some() {
            return None;
        }
        if self.count >= self.settings.points {
            self.ending = Some(Ending::TooManyPoints);
            return None;
        }
        let base = self.point.clone()?;
        let span = self.settings.to - self.settings.from;
        if self.count > 1 && (base.r - self.settings.from) * span <= 0.0 {
            self.ending = Some(Ending::ReachedStart);
            return None;
        }
        loop {
            match self.attempt(&base) {
                Ok(point) => return Some(point),
                Err(Stop::Refused(error)) => {
                    self.ending = Some(Ending::Refused(error));
                    return None;
                }
                Err(Stop::Retry(failure)) => {
                    self.step *= 0.4;
                    if self.step < self.settings.smallest_step {
                        self.ending = Some(Ending::StepTooSmall(failure));
                        return None;
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::continuation::Linearisation;
    use nalgebra::DMatrix;

    /// z² + r² = 1: two folds.
    #[derive(Clone)]
    struct Circle;

    impl ZeroProblem for Circle {
        type Error = std::fmt::Error;
        type Extra = ();

        fn evaluate(
            &mut self,
            z: &DVector<f64>,
            r: f64,
        ) -> Result<Linearisation<()>, std::fmt::Error> {
            Ok(Linearisation {
                residual: DVector::from_element(1, z[0] * z[0] + r * r - 1.0),
                jacobian: DMatrix::from_element(1, 1, 2.0 * z[0]),
                design: DVector::from_element(1, 2.0 * r),
                extra: (),
            })
        }

        fn scale(&self) -> DVector<f64> {
            DVector::from_element(1, 1.0)
        }
    }

    #[test]
    fn goes_through_a_fold_and_comes_back() {
        let start = DVector::from_element(1, 1.0);
        let (mut branch, first) =
            Branch::start(Circle, start, Settings::new(0.0, 2.0, 1e-12)).unwrap();
        let points: Vec<_> = std::iter::once(first).chain(branch.by_ref()).collect();
        assert_eq!(branch.ending(), Some(&Ending::ReachedStart));
        let largest = points.iter().map(|point| point.r).fold(0.0, f64::max);
        assert!((0.9..=1.0 + 1e-12).contains(&largest), "{largest}");
        assert!(points.last().unwrap().z[0] < -0.9);
        assert!(
            points
                .iter()
                .all(|p| (p.z[0].hypot(p.r) - 1.0).abs() < 1e-10)
        );
        assert!(
            points
                .windows(2)
                .any(|pair| pair[0].tangent_r * pair[1].tangent_r < 0.0)
        );
    }

    #[test]
    fn ends_exactly_at_the_end() {
        let start = DVector::from_element(1, 1.0);
        let (mut branch, _) = Branch::start(Circle, start, Settings::new(0.0, 0.7, 1e-12)).unwrap();
        let last = branch.by_ref().last().unwrap();
        assert_eq!(last.r, 0.7);
        assert!((last.z[0] - (1.0_f64 - 0.49).sqrt()).abs() < 1e-12);
        assert_eq!(branch.ending(), Some(&Ending::ReachedEnd));
    }

    #[test]
    fn a_point_between_two_lies_on_the_branch() {
        let start = DVector::from_element(1, 1.0);
        let (mut branch, _) = Branch::start(Circle, start, Settings::new(0.0, 2.0, 1e-12)).unwrap();
        assert!(branch.link().is_none());
        let last = branch.by_ref().take(4).last().unwrap();
        let mut link = branch.link().unwrap().clone();
        let point = link.between(0.3).unwrap();
        assert!((point.z[0].hypot(point.r) - 1.0).abs() < 1e-12);
        assert!(point.r < last.r && point.tangent_r > last.tangent_r);
    }
}
