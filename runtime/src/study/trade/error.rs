//! Why there is no trade.

use crate::flow::FlowError;
use crate::model::ModelInfo;
use crate::shooting::OrbitError;

/// Why there is no trade.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TradeError {
    /// The model has no contact.
    #[error("`{model}` has no friction: there is nothing to trade")]
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

/// Whether a model has friction that can be smoothed.
///
/// # Errors
/// It has none, or only laws with internal state.
pub(super) fn tradable(info: &ModelInfo) -> Result<(), TradeError> {
    let model = info.command;
    match info.only_form() {
        Some(reason) => Err(TradeError::OnlyForm { model, reason }),
        None if info.contacts.is_empty() => Err(TradeError::NoFriction { model }),
        None => Ok(()),
    }
}
