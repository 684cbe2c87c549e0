//! Steps along a smooth stretch: in closed form where the field is linear, by DOP853 elsewhere.

use crate::field::Work;
use crate::field::exact::{ExactField, ExactSystem};
use crate::integrate::explicit::{Settings, Stepper};
use crate::integrate::linear::{LinearFlow, LinearStepper};
use crate::integrate::{Carried, Dense, IntegrationError};
use crate::model::Model;
use crate::scalar::Inline;

/// Makes steps, one at a time.
pub(super) enum Steps<'s, 'f, M: Model<N>, V, const N: usize> {
    Linear(LinearStepper<'s, V, N>),
    Explicit(Stepper<'s, ExactField<'f, M, N>, V, N>),
}

macro_rules! either {
    ($steps:ident, $stepper:ident => $call:expr) => {
        match $steps {
            Self::Linear($stepper) => $call,
            Self::Explicit($stepper) => $call,
        }
    };
}

impl<'s, 'f, M: Model<N>, V: Carried<N>, const N: usize> Steps<'s, 'f, M, V, N> {
    /// Begins at `from` at this time, for the rest of a span: along `linear`, if the field is known as such.
    pub(super) fn begin(
        field: &'s ExactField<'f, M, N>,
        linear: Option<&'s LinearFlow<N>>,
        settings: Settings,
        from: V,
        (time, span): (f64, f64),
    ) -> Self {
        match linear {
            Some(flow) => Self::Linear(LinearStepper::new(flow, settings.steps, from, time)),
            None => Self::Explicit(Stepper::new(field, settings, from, time, span)),
        }
    }

    /// Whether they are made in closed form.
    pub(super) fn is_linear(&self) -> bool {
        matches!(self, Self::Linear(_))
    }

    /// Whether a motion can begin where they do.
    pub(super) fn check_start(&self) -> Result<(), IntegrationError> {
        either!(self, stepper => stepper.check_start())
    }

    pub(super) fn from(&self) -> &V {
        either!(self, stepper => stepper.from())
    }

    /// The state at the end of the step.
    pub(super) fn end(&self) -> &[f64; N] {
        match self {
            Self::Linear(stepper) => stepper.end(),
            Self::Explicit(stepper) => stepper.end().state(),
        }
    }

    pub(super) fn time(&self) -> f64 {
        either!(self, stepper => stepper.time())
    }

    pub(super) fn length(&self) -> f64 {
        either!(self, stepper => stepper.length())
    }

    pub(super) fn work(&self) -> Work {
        either!(self, stepper => stepper.work)
    }

    /// The length that the next attempt will try, and the slope where it begins, if errors decide the length.
    pub(super) fn proposal(&self) -> Option<(f64, &[f64; N])> {
        match self {
            Self::Linear(_) => None,
            Self::Explicit(stepper) => {
                let slope = stepper.from_slope().state();
                stepper.proposal().map(|length| (length, slope))
            }
        }
    }

    /// Makes a step at most `limit` long.
    pub(super) fn attempt(&mut self, limit: f64) -> Result<(), IntegrationError> {
        either!(self, stepper => stepper.attempt(limit))
    }

    /// Ends the step on the first corner of the field inside it; a linear field has none.
    pub(super) fn stop_at_corner(&mut self) -> Result<(), IntegrationError> {
        match self {
            Self::Linear(_) => Ok(()),
            Self::Explicit(stepper) => stepper.stop_at_corner(),
        }
    }

    /// Makes the same step with another length, not longer.
    pub(super) fn shorten(&mut self, length: f64) -> Result<(), IntegrationError> {
        either!(self, stepper => stepper.shorten(length))
    }

    /// The state to which a step of this length would lead.
    pub(super) fn step_map(&mut self, length: f64) -> [f64; N] {
        either!(self, stepper => stepper.step_map(length))
    }

    /// How far the dense output of the last attempt is known to be off, relative to the magnitude of the motion: of a motion
    /// in closed form it is an approximation of its own, that of DOP853 errs as the step does.
    pub(super) fn blur(&self) -> f64 {
        match self {
            Self::Linear(stepper) => stepper.error(),
            Self::Explicit(_) => 0.0,
        }
    }

    /// The state inside the step, as true as its end.
    pub(super) fn between(&mut self, theta: f64, dense: &Dense<N>) -> [f64; N] {
        match self {
            Self::Linear(stepper) => stepper.step_map(theta * stepper.length()),
            Self::Explicit(_) => dense.state(theta),
        }
    }

    /// f at any state.
    pub(super) fn slope_at(&mut self, state: &[f64; N]) -> [f64; N] {
        either!(self, stepper => stepper.slope_at(state))
    }

    /// The polynomial of degree 7 through the step.
    pub(super) fn dense(&mut self) -> Dense<N> {
        either!(self, stepper => stepper.dense())
    }

    /// Magnitude of the terms of each relative speed along the step, where it is in closed form: there speeds may die away
    /// to any part of what they were at the beginning of the stretch, and still be right.
    pub(super) fn terms_of_speeds(
        &self,
        system: &ExactSystem<M, N>,
        speeds: &M::PerContact<f64>,
    ) -> Option<M::PerContact<f64>> {
        let Self::Linear(stepper) = self else {
            return None;
        };
        let (terms, gradients) = (stepper.terms(), system.gradients()?);
        Some(Inline::from_fn(|i| {
            let made = gradients[i]
                .iter()
                .map(|(j, slope)| (slope * terms[j]).abs());
            speeds.as_ref()[i].abs() + made.sum::<f64>()
        }))
    }

    /// Takes the end of the step without `drift`, a rounding error of it, as the beginning of the next.
    pub(super) fn commit_without(&mut self, drift: &[f64; N]) -> Result<(), IntegrationError> {
        match self {
            Self::Linear(stepper) => stepper.commit_without(drift),
            Self::Explicit(stepper) => {
                stepper.commit_without(drift);
                Ok(())
            }
        }
    }
}
