//! Why the program does not do what it was asked.

use std::fmt;
use std::io::{IsTerminal, Write};

use super::text::number;
use super::width::fitted;
use crate::flow::FlowError;
use crate::shooting::OrbitError;
use crate::study::StudyError;
use crate::study::trade::TradeError;

/// The exit code of what was interrupted, as shells have it: 128 and the number of the signal.
pub(super) const INTERRUPTED: u8 = 130;

/// The exit code of what can be continued by the same words, as `sysexits.h` has it: schedulers start it again.
pub(super) const CONTINUED: u8 = 75;

/// A failure with the message for the user.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Failure {
    message: String,
    code: u8,
}

/// The error that the command line makes no sense, formatted.
macro_rules! refuse {
    ($($message:tt)*) => { Err($crate::app::failure::Failure::usage(format!($($message)*))) };
}
pub(super) use refuse;

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

    /// What was asked was ended before it was done.
    pub(super) fn interrupted(what: &str) -> Self {
        Self {
            message: format!("interrupted: {what}"),
            code: INTERRUPTED,
        }
    }

    /// What was asked is to be continued.
    pub(super) fn continued(what: &str) -> Self {
        Self {
            message: format!("interrupted: {what}; `--resume` goes on from there"),
            code: CONTINUED,
        }
    }

    /// What a study of this model ran into, in the model's own words.
    pub(super) fn of(error: &StudyError) -> Self {
        let message = match error {
            StudyError::Orbit(OrbitError::Equilibrium { state }) => format!(
                "no periodic orbit was found, only an equilibrium: the motion settles at {state}; `--start` looks elsewhere"
            ),
            StudyError::Orbit(OrbitError::NotIsolated { state, period }) => format!(
                "the motion through {state} is periodic, with the period {}, but so are those beside it: the orbits form a \
                 family, and none is singled out",
                number(*period, 9)
            ),
            other => format!("{other}{}", way_out(other)),
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
        let mut stderr = std::io::stderr();
        let message = format!("error: {self}\n");
        let _ = match stderr.is_terminal() {
            true => write!(stderr, "{}", fitted(&message)),
            false => write!(stderr, "{message}"),
        };
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

/// What the command line offers after such an error.
fn way_out(error: &StudyError) -> &'static str {
    match error {
        StudyError::NoEquilibrium { .. } => "; `--start` says where to look first",
        StudyError::Driven { .. } => "; `orbit` finds the motion that answers it",
        StudyError::NotIsolated { .. } => "; `simulate` shows where a motion comes to rest",
        StudyError::NoHopf => ": `equilibria` shows what it has",
        StudyError::Orbit(OrbitError::NotSettled { .. }) => {
            "; give `--start` and `--period`, or another start"
        }
        StudyError::Flow(FlowError::NoExactStops { .. })
        | StudyError::Orbit(OrbitError::Flow(FlowError::NoExactStops { .. })) => {
            ", as with `--smooth tanh:1e4`"
        }
        _ => "",
    }
}

/// Whether other words on the command line are the way out.
fn is_usage(error: &StudyError) -> bool {
    let flow = match error {
        StudyError::NothingToSmooth
        | StudyError::NothingToFollow
        | StudyError::Driven { .. }
        | StudyError::NotIsolated { .. }
        | StudyError::Trade(TradeError::NoFriction { .. } | TradeError::OnlyForm { .. }) => {
            return true;
        }
        StudyError::Flow(flow) | StudyError::Orbit(OrbitError::Flow(flow)) => flow,
        _ => return false,
    };
    matches!(
        flow,
        FlowError::Parameter(_)
            | FlowError::Smoothing(_)
            | FlowError::Standing { .. }
            | FlowError::Misplaced { .. }
            | FlowError::NoExactStops { .. }
    )
}
