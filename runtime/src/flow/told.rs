//! Failures of a motion in the words of its model.

use super::error::FlowError;
use super::reach::Beyond;
use crate::integrate::IntegrationError;
use crate::model::{ContactId, ModelInfo};

/// How far ahead of where a motion ended its formulas are tried, as powers of two of the unit of time.
const REACHES: std::ops::Range<i32> = -60..-10;
/// A state so many times as large as the usual ones, half of all digits, has left where it belongs.
const GROWN: f64 = 1.0 / ROOT_OF_EPSILON;
const ROOT_OF_EPSILON: f64 = 1.490_116_119_384_765_6e-8;

/// The largest state and its number, if it has left the usual ones of this model behind.
fn grown(model: &ModelInfo, state: &[f64]) -> Option<(usize, f64)> {
    let starts = model.states.iter().map(|state| state.start.abs());
    let usual = starts.fold(0.0, f64::max);
    let usual = if usual > 0.0 { usual } else { 1.0 };
    let sizes = state.iter().copied().enumerate();
    let largest = sizes.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    largest.filter(|(_, value)| value.is_finite() && value.abs() >= GROWN * usual)
}

impl FlowError {
    /// A law that is out of its bounds, with when and where.
    pub(super) fn beyond(found: &Beyond, time: f64, state: &[f64]) -> Self {
        Self::OutOfLaw {
            force: found.force,
            law: found.law,
            bound: found.field.bounds.describe(found.field.name),
            value: found.value,
            passes: found.passes,
            time,
            state: state.to_vec().into(),
        }
    }

    /// The same in the words of a model: states by their names, and a failure of the integrator for what it is where a state
    /// has left the usual ones behind.
    #[must_use]
    pub(crate) fn of(self, model: &'static ModelInfo) -> Self {
        let Self::Integration(error) = self else {
            return self.named(model);
        };
        let (time, state, cause) = match &error {
            IntegrationError::StepTooSmall { time, state, .. } => {
                (*time, state, "no step is small enough any more")
            }
            IntegrationError::NotFinite { time, state } => {
                (*time, state, "the right-hand side is not finite any more")
            }
            _ => return Self::Integration(error).named(model),
        };
        let unbounded = Self::unbounded(model, state, (time, cause));
        unbounded.unwrap_or_else(|| Self::Integration(error).named(model))
    }

    /// A motion that came to its end at this time for this cause, if a state has left the usual ones behind by then.
    pub(super) fn unbounded(
        model: &ModelInfo,
        state: &[f64],
        (time, cause): (f64, &'static str),
    ) -> Option<Self> {
        let (j, value) = grown(model, state)?;
        Some(Self::Unbounded {
            state: model.states.get(j).map_or("?", |state| state.name),
            value,
            time,
            cause,
        })
    }

    /// The same, with the formula that is not finite where the motion ended, or next to it on its way there.
    #[must_use]
    pub(crate) fn undefined(
        self,
        model: &'static ModelInfo,
        parameters: &[f64],
        rate: &dyn Fn(&[f64]) -> Option<Vec<f64>>,
    ) -> Self {
        let Self::Integration(
            IntegrationError::NotFinite { time, state }
            | IntegrationError::StepTooSmall { time, state, .. },
        ) = &self
        else {
            return self;
        };
        let ahead = |rate: &Vec<f64>, reach: f64| -> Vec<f64> {
            state.iter().zip(rate).map(|(y, f)| y + reach * f).collect()
        };
        let found = model.culprit(parameters, state).or_else(|| {
            let rate = rate(state)?;
            let mut reaches = REACHES.map(|exponent| f64::from(exponent).exp2());
            reaches.find_map(|reach| model.culprit(parameters, &ahead(&rate, reach)))
        });
        match found {
            Some(culprit) => Self::Undefined {
                culprit,
                time: *time,
                state: state.clone().named(model),
            },
            None => self,
        }
    }

    /// The same, if contacts are hit together, with another one that is hit with them.
    pub(super) fn hit_with(self, other: ContactId, time: f64) -> Self {
        match self {
            Self::HitTogether { mut contacts, .. } => {
                contacts.push(other);
                contacts.sort_unstable();
                Self::HitTogether { contacts, time }
            }
            error => error,
        }
    }

    /// The same with the states by their names.
    #[must_use]
    pub(crate) fn named(self, model: &'static ModelInfo) -> Self {
        match self {
            Self::Integration(error) => Self::Integration(error.named(model)),
            Self::OutOfLaw {
                force,
                law,
                bound,
                value,
                passes,
                time,
                state,
            } => Self::OutOfLaw {
                force,
                law,
                bound,
                value,
                passes,
                time,
                state: state.named(model),
            },
            other => other,
        }
    }

    /// The same of a motion that began so much earlier.
    #[must_use]
    pub(crate) fn later(mut self, by: f64) -> Self {
        match &mut self {
            Self::Integration(error) => *error = error.clone().later(by),
            Self::Unbounded { time, .. }
            | Self::OutOfLaw { time, .. }
            | Self::Undefined { time, .. }
            | Self::Backwards { time, .. }
            | Self::InconsistentMode { time, .. }
            | Self::NotBorne { time, .. }
            | Self::Impulsive { time, .. }
            | Self::NoImpulse { time, .. }
            | Self::Gains { time, .. }
            | Self::HitTogether { time, .. }
            | Self::Chattering { time, .. } => *time += by,
            _ => {}
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_ends_a_later_stretch_ends_later() {
        let contact = ContactId {
            number: 0,
            name: "F",
        };
        let error = FlowError::Chattering {
            contact,
            time: 0.5,
            events: 101,
        };
        let said = error.later(2.0).to_string();
        assert!(said.ends_with("up to t = 2.5"), "{said}");
    }
}
