//! Why a question has no answer.

use crate::continuation::Failure;
use crate::flow::FlowError;
use crate::shooting::{OrbitError, SwitchError};

/// Why a case has no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StudyError {
    /// The size of a smoothing was to be followed, but there is no smoothing.
    #[error("there is no smoothing whose size could be followed")]
    NothingToSmooth,
    /// A branch was asked for, but not along what.
    #[error("a branch needs a design variable to be followed along")]
    NothingToFollow,
    /// The errors of smoothing cannot be measured.
    #[error(transparent)]
    Trade(#[from] TradeError),
    /// No equilibrium was found.
    #[error("no equilibrium that could be followed was found from {starts} starts")]
    NoEquilibrium {
        /// From how many places it was looked for.
        starts: usize,
    },
    /// All that rests is held by friction.
    #[error(
        "no equilibrium stands alone that could be followed: what rests are sets of states that friction holds ({modes}); without a range they are listed with their bounds, and a smooth copy has single equilibria"
    )]
    OnlySets {
        /// The modes of their contacts, as they are spelt.
        modes: String,
    },
    /// A driven model never rests.
    #[error("`{model}` has no equilibrium: its drive `{phase}` never stands still")]
    Driven {
        /// The model.
        model: &'static str,
        /// The phase of its drive.
        phase: &'static str,
    },
    /// A law holds any force between its stops while it rests.
    #[error(
        "`{model}` has no equilibrium that stands alone: at rest `{law}` holds any force between its stops"
    )]
    NotIsolated {
        /// The model.
        model: &'static str,
        /// The law.
        law: &'static str,
    },
    /// An equilibrium cannot be followed.
    #[error("the equilibrium cannot be followed: {0}")]
    Equilibrium(Failure<FlowError>),
    /// The branch has no such special point.
    #[error("{}", no_special(.wanted.as_deref(), .known, .labels))]
    NoSpecial {
        /// Its label, if one was asked for.
        wanted: Option<String>,
        /// The kinds that are followed.
        known: &'static str,
        /// The labels that there are.
        labels: Vec<String>,
    },
    /// A special point that has no curve here.
    #[error(
        "{label} is a {kind} point, and only folds, flips, torus, grazing and sliding points of orbits, and folds and Hopf points of \
         equilibria can be followed in two parameters"
    )]
    NotFollowed {
        /// Its label.
        label: String,
        /// What it is.
        kind: &'static str,
    },
    /// A curve cannot be begun.
    #[error("the special point cannot be followed: {0}")]
    Curve(Failure<FlowError>),
    /// No orbit was found.
    #[error(transparent)]
    Orbit(#[from] OrbitError),
    /// The equilibrium has no Hopf point on the way.
    #[error("the equilibrium has no Hopf point there from which orbits could be followed")]
    NoHopf,
    /// No orbit begins at the Hopf point.
    #[error("no orbit was found that begins at the Hopf point: {0}")]
    Hopf(SwitchError),
    /// The motion cannot be followed.
    #[error(transparent)]
    Flow(#[from] FlowError),
}

fn no_special(wanted: Option<&str>, known: &str, labels: &[String]) -> String {
    let there = match labels {
        [] => "no special point at all".to_owned(),
        labels => labels.join(", "),
    };
    let there = format!("where the second range begins, the branch has {there}");
    match wanted {
        Some(wanted) => format!("there is no special point {wanted}: {there}"),
        None => format!("there is no {known} point to be followed in two parameters: {there}"),
    }
}

/// Why there is no trade.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TradeError {
    /// The model has no contact.
    #[error("`{model}` has no contact: there is nothing to trade")]
    NoFriction {
        /// The model.
        model: &'static str,
    },
    /// All friction of the model has internal state.
    #[error("`{model}` has nothing to trade: {reason}")]
    OnlyForm {
        /// The model.
        model: &'static str,
        /// Why there are no other forms.
        reason: String,
    },
    /// The exact orbit cannot be shot again.
    #[error("the exact orbit cannot be reproduced: {0}")]
    Orbit(#[from] OrbitError),
    /// The exact motion cannot be followed.
    #[error(transparent)]
    Flow(#[from] FlowError),
}
