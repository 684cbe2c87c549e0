//! The orbit's smooth copies, from the nearest to the exact law to the farthest.

use std::ops::ControlFlow;

use super::fit::Fit;
use super::lost::Lost;
use super::precision;
use super::record::{Curve, Finding, Point, Scope, Trade, Watch};
use super::shoot::{Effort, Shooting, cost, follow, shoot};
use crate::field::{Design, Kernel, Smoothing, SmoothingError, Work};
use crate::flow::FlowError;
use crate::integrate::Tolerance;
use crate::motion::Family;
use crate::shooting::{Guess, Orbit};
use crate::study::predict::Prediction;
use crate::study::question::{Along, Case, Dynamics};
use crate::study::system::System;

/// Tolerances tried in this order: where a layer is thin, a looser one can leave less noise for Newton.
const EFFORTS: [Effort; 4] = [
    Effort::TIGHT,
    Effort::at(1e-10, 1e-9),
    Effort::at(1e-8, 1e-9),
    Effort::at(1e-10, 1e-8),
];
/// Ratio of periods above which an orbit is another one.
const OTHER: f64 = 2.0;

/// Everything known before the first copy is sought.
pub(super) struct Copies<'a> {
    pub(super) system: &'a System,
    /// The exact case.
    pub(super) case: &'a Case,
    pub(super) orbit: &'a Orbit,
    pub(super) truth: &'a Shooting,
}

/// A copy that has the orbit.
pub(super) type Found = (Smoothing, Shooting);

impl Copies<'_> {
    pub(super) fn family(&self, smoothing: Smoothing, tolerance: Tolerance) -> Family {
        let case = Case {
            dynamics: Dynamics::Smoothed(smoothing),
            ..self.case.clone()
        };
        self.system.family(&case).with_tolerance(tolerance)
    }

    /// Adds everything about one kernel to a trade.
    pub(super) fn measure(&self, kernel: Kernel, scope: &Scope, all: &mut Trade, watch: Watch<'_>) {
        let (mut curve, found, mut verdict) = self.curve(kernel, scope, watch);
        for (smoothing, copy) in &found {
            if verdict.is_break() {
                break;
            }
            let family = self.family(*smoothing, Effort::TIGHT.tolerance);
            let precision = precision::of(Some(*smoothing), &family, copy, self.truth, scope);
            verdict = watch(Finding::Precision(&precision));
            all.precision.push(precision);
        }
        if let (Some(accuracy), None, false) = (scope.accuracy, &curve.refused, verdict.is_break())
        {
            curve.need = Some(self.need(&curve, &found, accuracy));
        }
        all.curves.push(curve);
        all.interrupted = verdict.is_break();
    }

    /// All copies of one kernel, and whether there shall be more.
    fn curve(
        &self,
        kernel: Kernel,
        scope: &Scope,
        watch: Watch<'_>,
    ) -> (Curve, Vec<Found>, ControlFlow<()>) {
        let sizes = if kernel.is_bump() {
            &scope.bump_sizes
        } else {
            &scope.sign_sizes
        };
        let mut curve = Curve {
            kernel,
            refused: self.refusal(kernel),
            points: Vec::new(),
            lost: Vec::new(),
            frequency: None,
            max_abs: Vec::new(),
            need: None,
        };
        let mut found: Vec<Found> = Vec::new();
        let mut verdict = ControlFlow::Continue(());
        if curve.refused.is_some() {
            return (curve, found, verdict);
        }
        for &size in sizes.iter().rev() {
            if verdict.is_break() {
                break;
            }
            let smoothing = curve.at(size);
            match self.point(smoothing, found.last()) {
                Ok((point, shooting)) => {
                    verdict = watch(Finding::Copy(kernel, &point));
                    curve.points.push(point);
                    found.push((smoothing, shooting));
                }
                Err(reason) => curve.lost.push((size, reason)),
            }
        }
        curve.points.reverse();
        curve.lost.reverse();
        found.reverse();
        let errors = |of: &dyn Fn(&Point) -> f64| {
            Fit::through(curve.points.iter().map(|point| (point.size, of(point))))
        };
        curve.frequency = errors(&|point| point.frequency);
        curve.max_abs = (0..self.truth.state.len())
            .map(|j| errors(&|point| point.max_abs[j]))
            .collect();
        (curve, found, verdict)
    }

    fn refusal(&self, kernel: Kernel) -> Option<SmoothingError> {
        let family = self.family(Smoothing { kernel, size: 1.0 }, Effort::TIGHT.tolerance);
        match family.at(0.0).err()? {
            FlowError::Smoothing(refusal) => Some(refusal),
            _ => None,
        }
    }

    /// One copy, measured and predicted.
    pub(super) fn point(
        &self,
        smoothing: Smoothing,
        finer: Option<&Found>,
    ) -> Result<(Point, Shooting), Lost> {
        let predicted = self.system.predict(self.case, self.orbit, smoothing);
        let (shooting, effort) = self.find(smoothing, predicted.as_ref().ok(), finer)?;
        let (frequency, max_abs) = shooting.errors(self.truth);
        let family = self.family(smoothing, effort.tolerance);
        let point = Point {
            size: smoothing.size,
            stiffness: self
                .system
                .stiffness(self.case, &self.orbit.place.state, smoothing),
            frequency,
            max_abs,
            resolution: shooting.resolution,
            cost: cost(&family, &shooting)?,
            found: shooting.work,
            predicted,
        };
        Ok((point, shooting))
    }

    /// Newton from where the copy is predicted, from the exact orbit, then from the next finer copy, by
    /// following it in the logarithm of its size.
    fn find(
        &self,
        smoothing: Smoothing,
        predicted: Option<&Prediction>,
        finer: Option<&Found>,
    ) -> Result<(Shooting, Effort), Lost> {
        let exact = self.truth.guess();
        let shifted = predicted.map(|prediction| {
            let mut guess = exact.clone();
            let state = guess.place.state.iter_mut();
            state.zip(&prediction.start).for_each(|(y, by)| *y += by);
            guess.period *= 1.0 - prediction.frequency;
            guess
        });
        let beside = finer.map(|(_, copy)| copy.guess());
        let mut last = Lost::NoCopy;
        for guess in shifted.into_iter().chain([exact]).chain(beside) {
            match self.converge(smoothing, &guess) {
                Ok(found) => return Ok(found),
                Err(reason) => last = reason,
            }
        }
        let Some((from, copy)) = finer else {
            return Err(last);
        };
        let (guess, work) = self.follow(*from, smoothing, copy)?;
        let (mut shooting, effort) = self.converge(smoothing, &guess)?;
        shooting.work += work;
        Ok((shooting, effort))
    }

    fn follow(
        &self,
        from: Smoothing,
        to: Smoothing,
        copy: &Shooting,
    ) -> Result<(Guess, Work), Lost> {
        let along = Along {
            design: Design::Smoothing,
            from: from.size,
            to: to.size,
        };
        let case = Case {
            dynamics: Dynamics::Smoothed(from),
            along: Some(along),
            ..self.case.clone()
        };
        follow(
            &self.system.family(&case),
            along.span(),
            &copy.guess(),
            Effort::TIGHT,
        )
    }

    fn converge(&self, smoothing: Smoothing, guess: &Guess) -> Result<(Shooting, Effort), Lost> {
        let mut last = Lost::NoCopy;
        for effort in EFFORTS {
            let family = self.family(smoothing, effort.tolerance);
            match shoot(&family, 0.0, guess, effort) {
                Ok(found) => match self.same(&found) {
                    Ok(()) => return Ok((found, effort)),
                    Err(reason) => return Err(reason),
                },
                Err(error) => last = error.into(),
            }
        }
        Err(last)
    }

    /// Whether this is the exact orbit's copy and not another orbit.
    fn same(&self, found: &Shooting) -> Result<(), Lost> {
        if found.count != self.truth.count {
            return Err(Lost::Crossings {
                found: found.count,
                wanted: self.truth.count,
            });
        }
        let ratio = found.period / self.truth.period;
        if !(1.0 / OTHER..=OTHER).contains(&ratio) {
            return Err(Lost::Longer { ratio });
        }
        Ok(())
    }
}
