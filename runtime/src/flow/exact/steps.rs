//! Steps along a smooth stretch: in closed form where the field is linear, by DOP853 elsewhere.

use super::forms::Forms;
use super::stretch::Known;
use crate::field::Work;
use crate::field::exact::{ExactField, ExactSystem};
use crate::integrate::explicit::{Settings, Stepper};
use crate::integrate::linear::LinearStepper;
use crate::integrate::{Dense, IntegrationError, Motion, Tracked};
use crate::model::Model;
use crate::scalar::Inline;

/// Makes steps, one at a time.
pub(super) enum Steps<'s, 'f, M: Model<N>, const N: usize> {
    Linear(LinearStepper<'s, N>, &'s Forms<M, N>),
    Explicit(Stepper<'s, ExactField<'f, M, N>, [f64; N], N>),
    /// With derivatives.
    Differentiated(Stepper<'s, ExactField<'f, M, N>, Motion<N>, N>),
}

macro_rules! either {
    ($steps:ident, $stepper:ident => $call:expr) => {
        match $steps {
            Self::Linear($stepper, _) => $call,
            Self::Explicit($stepper) => $call,
            Self::Differentiated($stepper) => $call,
        }
    };
}

impl<'s, 'f, M: Model<N>, const N: usize> Steps<'s, 'f, M, N> {
    /// Begins at `from` at this time, for the rest of a span: along `linear`, if the field is known as such.
    pub(super) fn begin(
        field: &'s ExactField<'f, M, N>,
        linear: Option<&'s Known<M, N>>,
        settings: Settings,
        from: Tracked<N>,
        (time, span): (f64, f64),
    ) -> Self {
        if let Some(known) = linear {
            let stepper = LinearStepper::new(&known.flow, settings.steps, from, time);
            return Self::Linear(stepper, &known.guards);
        }
        match from {
            Tracked::State(from) => Self::Explicit(Stepper::new(field, settings, from, time, span)),
            Tracked::Motion(from) => {
                Self::Differentiated(Stepper::new(field, settings, from, time, span))
            }
        }
    }

    /// The motion in closed form and the guards along it, if it is.
    pub(super) fn linear(&self) -> Option<(&LinearStepper<'s, N>, &'s Forms<M, N>)> {
        match self {
            Self::Linear(stepper, guards) => Some((stepper, guards)),
            Self::Explicit(_) | Self::Differentiated(_) => None,
        }
    }

    /// Whether a motion can begin where they do.
    pub(super) fn check_start(&self) -> Result<(), IntegrationError> {
        either!(self, stepper => stepper.check_start())
    }

    /// The state where the step begins.
    pub(super) fn from(&self) -> &[f64; N] {
        match self {
            Self::Linear(stepper, _) => stepper.from(),
            Self::Explicit(stepper) => stepper.from(),
            Self::Differentiated(stepper) => &stepper.from().state,
        }
    }

    /// Where they have come to, with the derivatives.
    pub(super) fn arrived(&self) -> Result<Tracked<N>, IntegrationError> {
        match self {
            Self::Linear(stepper, _) => stepper.arrived(),
            Self::Explicit(stepper) => Ok(Tracked::State(*stepper.from())),
            Self::Differentiated(stepper) => Ok(Tracked::Motion(*stepper.from())),
        }
    }

    /// The state at the end of the step.
    pub(super) fn end(&self) -> &[f64; N] {
        match self {
            Self::Linear(stepper, _) => stepper.end(),
            Self::Explicit(stepper) => stepper.end(),
            Self::Differentiated(stepper) => &stepper.end().state,
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
            Self::Linear(..) => None,
            Self::Explicit(stepper) => {
                let slope = stepper.from_slope();
                stepper.proposal().map(|length| (length, slope))
            }
            Self::Differentiated(stepper) => {
                let slope = &stepper.from_slope().state;
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
            Self::Linear(..) => Ok(()),
            Self::Explicit(stepper) => stepper.stop_at_corner(),
            Self::Differentiated(stepper) => stepper.stop_at_corner(),
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

    /// The state inside the step, as true as its end.
    pub(super) fn between(&mut self, theta: f64, dense: &Dense<N>) -> [f64; N] {
        match self {
            Self::Linear(stepper, _) => stepper.step_map(theta * stepper.length()),
            Self::Explicit(_) | Self::Differentiated(_) => dense.state(theta),
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
        let (stepper, _) = self.linear()?;
        let (terms, gradients) = (stepper.terms(), system.gradients()?);
        Some(Inline::from_fn(|i| {
            let made = gradients[i]
                .iter()
                .map(|(j, slope)| (slope * terms[j]).abs());
            speeds.as_ref()[i].abs() + made.sum::<f64>()
        }))
    }

    /// Takes the end of the step without `drift`, a rounding error of it, as the beginning of the next.
    pub(super) fn commit_without(&mut self, drift: &[f64; N]) {
        either!(self, stepper => stepper.commit_without(drift));
    }
}
