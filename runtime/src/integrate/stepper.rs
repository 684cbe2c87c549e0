//! One step of DOP853 at a time.

use super::IntegrationError;
use super::carried::Carried;
use super::control::Control;
use super::dense::Dense;
use super::dop853::{DENSE, END, MORE, STAGES, Weights};
use super::explicit::Settings;
use crate::field::{Field, Work};

/// Makes steps of DOP853, one at a time.
#[derive(Debug, Clone)]
pub struct Stepper<'f, F, V, const N: usize> {
    pub(super) field: &'f F,
    pub(super) settings: Settings,
    pub(super) control: Control,
    pub(super) time: f64,
    /// The end of the span.
    pub(super) until: f64,
    pub(super) length: f64,
    pub(super) from: V,
    pub(super) end: V,
    /// Slopes of the twelve stages, and the one at the end of the step.
    pub(super) slopes: [V; 13],
    /// Where the twelfth stage looked, for the test of stiffness.
    pub(super) last_look: [f64; N],
    /// The guard that ends the step.
    pub(super) fallen: Option<usize>,
    /// What has been counted so far.
    pub work: Work,
}

impl<'f, F: Field<N>, V: Carried<N>, const N: usize> Stepper<'f, F, V, N> {
    /// Begins at `from`; the first step length is guessed from the field, for an interval `span`.
    ///
    /// Whether a motion can begin there, [`Stepper::check_start`] says: a result that is handed on would be copied.
    pub fn new(field: &'f F, settings: Settings, from: V, time: f64, span: f64) -> Self {
        let mut stepper = Self {
            field,
            settings,
            control: Control::new(span),
            time,
            until: time + span,
            length: 0.0,
            from,
            end: from,
            slopes: [V::NOTHING; 13],
            last_look: *from.state(),
            fallen: None,
            work: Work::default(),
        };
        from.slope(field, &mut stepper.work, &mut stepper.slopes[0]);
        stepper
    }

    /// Whether a motion can begin here.
    ///
    /// # Errors
    /// `NotFinite` if the state or its slope is not.
    pub fn check_start(&self) -> Result<(), IntegrationError> {
        if self.from.is_finite() && self.slopes[0].is_finite() {
            Ok(())
        } else {
            Err(self.not_finite())
        }
    }

    /// Where the step begins.
    pub fn from(&self) -> &V {
        &self.from
    }

    /// Where the step ends.
    pub fn end(&self) -> &V {
        &self.end
    }

    /// The slope where the step begins.
    pub fn from_slope(&self) -> &V {
        &self.slopes[0]
    }

    /// The time at which the step begins.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// The length of the step.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// The number of the guard of the field that falls at the end of the step, if one does.
    pub fn fallen(&self) -> Option<usize> {
        self.fallen
    }

    /// The length that the next attempt will try.
    pub fn proposal(&self) -> Option<f64> {
        self.control.proposal
    }

    /// Makes a step within the tolerance and at most `limit` long, from where the last was committed.
    ///
    /// # Errors
    /// `StepTooSmall`, `NotFinite`, `TooManySteps` or `Stiff`.
    pub fn attempt(&mut self, limit: f64) -> Result<(), IntegrationError> {
        let mut length = self.first_length().min(limit);
        loop {
            // A step that nearly reaches the limit shall reach it, not leave a crumb.
            if 1.01 * length >= limit {
                length = limit;
            }
            self.spend()?;
            self.trial(length);
            let error = self.error();

            if error <= 1.0 && self.close() {
                self.control.accept(length, error);
                return self.judge_stiffness();
            }
            self.work.rejected += 1;
            length = self.control.reject(length, error);
            if self.control.exhausted(length, self.time) {
                return Err(self.too_small(length, error));
            }
        }
    }

    /// Makes the same step with another length, not longer than the accepted one; without a test of its error.
    ///
    /// # Errors
    /// `NotFinite` if the field is not finite on the way.
    pub fn shorten(&mut self, length: f64) -> Result<(), IntegrationError> {
        self.trial(length);
        if self.close() {
            Ok(())
        } else {
            Err(self.not_finite())
        }
    }

    /// The state to which a step of this length would lead: the step map on which events are located.
    pub fn step_map(&mut self, length: f64) -> [f64; N] {
        let from = *self.from.state();
        let mut slopes = [[0.0; N]; 13];
        slopes[0] = *self.slopes[0].state();
        stages(self.field, &from, length, &mut slopes, &mut self.work);
        combine(&from, length, END, &slopes)
    }

    /// f at any state, counted.
    pub fn slope_at(&mut self, state: &[f64; N]) -> [f64; N] {
        self.work.evaluations += 1;
        self.field.f(state)
    }

    /// The polynomial of degree 7 through the step.
    pub fn dense(&mut self) -> Dense<N> {
        let from = *self.from.state();
        let mut slopes = [[0.0; N]; 16];
        for (plain, carried) in slopes.iter_mut().zip(&self.slopes) {
            *plain = *carried.state();
        }
        // Each on its own, for the same reason as the stages.
        let (length, zero) = (self.length, [0.0; N]);
        slopes[13] = self.slope_at(&combine(&from, length, MORE[0], &slopes));
        slopes[14] = self.slope_at(&combine(&from, length, MORE[1], &slopes));
        slopes[15] = self.slope_at(&combine(&from, length, MORE[2], &slopes));
        let higher = [
            combine(&zero, length, DENSE[0], &slopes),
            combine(&zero, length, DENSE[1], &slopes),
            combine(&zero, length, DENSE[2], &slopes),
            combine(&zero, length, DENSE[3], &slopes),
        ];
        let ends = (&slopes[0], &slopes[12]);
        Dense::new(from, *self.end.state(), ends, self.length, higher)
    }

    /// Takes the end of the step as the beginning of the next.
    pub fn commit(&mut self) {
        self.work.steps += 1;
        self.time += self.length;
        self.from = self.end;
        self.slopes[0] = self.slopes[12];
    }

    /// The same without `drift`, a rounding error of the end.
    pub fn commit_without(&mut self, drift: &[f64; N]) {
        self.end.state_mut().add(-1.0, drift);
        self.commit();
    }

    fn trial(&mut self, length: f64) {
        self.length = length;
        let (slopes, work) = (&mut self.slopes, &mut self.work);
        self.last_look = *stages(self.field, &self.from, length, slopes, work).state();
        self.end = combine(&self.from, length, END, &self.slopes);
        self.end.total(length, END, &self.slopes);
    }

    /// Evaluates the slope at the end; false if anything there is not finite.
    fn close(&mut self) -> bool {
        (self.end).slope(self.field, &mut self.work, &mut self.slopes[12]);
        self.end.is_finite() && self.slopes[12].is_finite()
    }

    fn spend(&mut self) -> Result<(), IntegrationError> {
        let steps = self.work.steps + self.work.rejected;
        if steps < self.settings.steps {
            return Ok(());
        }
        Err(IntegrationError::TooManySteps {
            steps,
            time: self.time,
            state: self.from.state().to_vec().into(),
        })
    }

    fn too_small(&self, step: f64, error: f64) -> IntegrationError {
        if !error.is_finite() {
            return self.not_finite();
        }
        IntegrationError::StepTooSmall {
            time: self.time,
            step,
            state: self.from.state().to_vec().into(),
        }
    }

    fn not_finite(&self) -> IntegrationError {
        IntegrationError::NotFinite {
            time: self.time,
            state: self.from.state().to_vec().into(),
        }
    }
}

/// Evaluates the slopes of stages 2 to 12 from that of the first; where the last looked.
#[inline]
fn stages<F: Field<N>, V: Carried<N>, const N: usize>(
    field: &F,
    from: &V,
    length: f64,
    slopes: &mut [V; 13],
    work: &mut Work,
) -> V {
    // Each stage on its own, so that its weights are constants to the compiler.
    macro_rules! stage {
        ($number:literal) => {{
            let look = combine(from, length, STAGES[$number], slopes);
            look.slope(field, work, &mut slopes[$number + 1]);
            look
        }};
    }
    stage!(0);
    stage!(1);
    stage!(2);
    stage!(3);
    stage!(4);
    stage!(5);
    stage!(6);
    stage!(7);
    stage!(8);
    stage!(9);
    stage!(10)
}

/// from + h Σ wⱼ kⱼ: the increments are summed before the state is touched, to round once.
#[inline(always)]
fn combine<V: Carried<N>, const N: usize>(
    from: &V,
    length: f64,
    weights: Weights,
    slopes: &[V],
) -> V {
    let mut end = *from;
    end.add(length, &weighted(weights, slopes));
    end
}

/// Σ wⱼ kⱼ.
#[inline(always)]
pub(super) fn weighted<V: Carried<N>, const N: usize>(weights: Weights, slopes: &[V]) -> V {
    let mut sum = V::NOTHING;
    for &(j, weight) in weights {
        sum.add(weight, &slopes[j]);
    }
    sum
}
