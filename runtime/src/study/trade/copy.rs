//! The orbit's smooth copies: each is sought by itself, and by those nearer to the exact law where that does not suffice.

use std::sync::OnceLock;

use super::lost::Lost;
use super::record::{Point, Scope};
use super::shoot::{Effort, Shooting, cost, follow, shoot};
use crate::field::{Design, Kernel, Smoothing, SmoothingError, Work};
use crate::flow::FlowError;
use crate::integrate::Tolerance;
use crate::motion::Family;
use crate::shooting::{Guess, Orbit};
use crate::study::error::{StudyError, TradeError};
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
    pub(super) case: Case,
    pub(super) orbit: Orbit,
    pub(super) truth: Shooting,
    pub(super) scope: &'a Scope,
    /// The copies of each kernel and size that were sought.
    sought: Vec<Vec<OnceLock<Result<Copy, Lost>>>>,
}

/// A copy that has the orbit.
type Copy = (Point, Shooting);

/// The same, as one from which others are found.
pub(super) type Found = (Smoothing, Shooting);

impl<'a> Copies<'a> {
    /// The exact orbit of a case.
    ///
    /// # Errors
    /// There is none, or it cannot be shot again.
    pub(super) fn of(system: &'a System, case: Case, scope: &'a Scope) -> Result<Self, StudyError> {
        let orbit = system.sought(&case)?.orbit(0.0)?;
        let family = system.family(&case);
        let truth = shoot(&family, 0.0, &orbit.guess(), Effort::TIGHT).map_err(TradeError::from)?;
        let sizes = scope.kernels.iter().map(|kernel| scope.sizes(*kernel));
        let unsought = |sizes: &[f64]| sizes.iter().map(|_| OnceLock::new()).collect();
        Ok(Self {
            system,
            case,
            orbit,
            truth,
            scope,
            sought: sizes.map(unsought).collect(),
        })
    }

    pub(super) fn family(&self, smoothing: Smoothing, tolerance: Tolerance) -> Family {
        let case = Case {
            dynamics: Dynamics::Smoothed(smoothing),
            ..self.case.clone()
        };
        self.system.family(&case).with_tolerance(tolerance)
    }

    /// The copy of a kernel and a size of these places.
    pub(super) fn copy(&self, kernel: usize, place: usize) -> &Result<Copy, Lost> {
        self.sought[kernel][place].get_or_init(|| {
            let smoothing = self.scope.smoothing(kernel, place);
            self.point(smoothing, &|| self.finer(kernel, place))
        })
    }

    /// The next of those nearer to the exact law.
    fn finer(&self, kernel: usize, place: usize) -> Option<Found> {
        let mut finer = place + 1..self.sought[kernel].len();
        finer.find_map(|place| {
            let (_, shooting) = self.copy(kernel, place).as_ref().ok()?;
            Some((self.scope.smoothing(kernel, place), shooting.clone()))
        })
    }

    /// Why the model's laws do not accept a kernel, if they do not.
    pub(super) fn refusal(&self, kernel: Kernel) -> Option<SmoothingError> {
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
        finer: &dyn Fn() -> Option<Found>,
    ) -> Result<Copy, Lost> {
        let predicted = self.system.predict(&self.case, &self.orbit, smoothing);
        let (shooting, effort) = self.find(smoothing, predicted.as_ref().ok(), finer)?;
        let (frequency, max_abs) = shooting.errors(&self.truth);
        let family = self.family(smoothing, effort.tolerance);
        let point = Point {
            size: smoothing.size,
            stiffness: self
                .system
                .stiffness(&self.case, &self.orbit.place.state, smoothing),
            frequency,
            max_abs,
            resolution: shooting.resolution,
            cost: cost(&family, &shooting)?,
            found: shooting.work,
            predicted: predicted.map_err(|reason| reason.to_string()),
        };
        Ok((point, shooting))
    }

    /// Newton from where the copy is predicted, from the exact orbit, then from the next finer copy, by
    /// following it in the logarithm of its size.
    fn find(
        &self,
        smoothing: Smoothing,
        predicted: Option<&Prediction>,
        finer: &dyn Fn() -> Option<Found>,
    ) -> Result<(Shooting, Effort), Lost> {
        let exact = self.truth.guess();
        let shifted = predicted.map(|prediction| {
            let mut guess = exact.clone();
            let state = guess.place.state.iter_mut();
            state.zip(&prediction.start).for_each(|(y, by)| *y += by);
            guess.period *= 1.0 - prediction.frequency;
            guess
        });
        if let Some(guess) = shifted
            && let Ok(found) = self.converge(smoothing, &guess)
        {
            return Ok(found);
        }
        let lost = match self.converge(smoothing, &exact) {
            Ok(found) => return Ok(found),
            Err(reason) => reason,
        };
        let (from, copy) = finer().ok_or(lost)?;
        if let Ok(found) = self.converge(smoothing, &copy.guess()) {
            return Ok(found);
        }
        let (guess, work) = self.follow(from, smoothing, &copy)?;
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
