//! Why the program does not do what it was asked.

use std::io::Write;

use crate::flow::FlowError;
use crate::model::ModelInfo;
use crate::shooting::OrbitError;
use crate::study::StudyError;
use crate::study::trade::TradeError;

/// A failure with the message for the user.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Failure {
    message: String,
    code: u8,
}

impl Failure {
    /// The command line makes no sense.
    pub(super) fn usage(message: impl Into<String>) -> Self {
        Self {
            message: message.into(),
            code: 2,
        }
    }

    /// What was asked could not be done.
    pub(super) fn failed(message: impl Into<String>) -> Self {
        Self {
            message: message.into(),
            code: 1,
        }
    }

    /// What a study of this model ran into, in the model's own words.
    pub(super) fn of(error: &StudyError, info: &ModelInfo) -> Self {
        let message = match error {
            StudyError::Orbit(OrbitError::Equilibrium { state }) => format!(
                "the motion settles on an equilibrium, {}: there is no periodic orbit to be found from this start",
                named(info, state)
            ),
            other => other.to_string(),
        };
        if is_usage(error) {
            Self::usage(message)
        } else {
            Self::failed(message)
        }
    }

    /// The exit code for it.
    pub(super) fn code(&self) -> u8 {
        self.code
    }

    /// Prints the message on stderr; if nobody listens, so be it.
    pub(super) fn report(&self) {
        let _ = writeln!(std::io::stderr(), "error: {}", self.message);
    }
}

/// Whether other words on the command line are the way out.
fn is_usage(error: &StudyError) -> bool {
    let flow = match error {
        StudyError::NothingToSmooth | StudyError::NothingToFollow => return true,
        StudyError::Flow(flow) | StudyError::Orbit(OrbitError::Flow(flow)) => flow,
        StudyError::Trade(TradeError::NoFriction { .. }) => return true,
        StudyError::Orbit(_)
        | StudyError::Trade(_)
        | StudyError::NoEquilibrium { .. }
        | StudyError::Equilibrium(_) => return false,
    };
    matches!(flow, FlowError::Parameter(_) | FlowError::Smoothing(_))
}

fn named(info: &ModelInfo, state: &[f64]) -> String {
    let pairs: Vec<String> = info
        .states
        .iter()
        .zip(state)
        .map(|(declared, value)| format!("{} = {}", declared.name, super::text::number(*value, 6)))
        .collect();
    pairs.join(", ")
}
