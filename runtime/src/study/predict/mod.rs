//! The error that a smoothing makes, predicted from the exact orbit alone (theory 7.2).
//!
//! A copy differs from the exact system in four ways: it creeps where a contact sticks, it loses time or gains speed
//! at each release, it takes time to cross from one direction of sliding to the other, and its sliding friction is not yet
//! quite the exact one. Each is a perturbation of the exact
//! orbit, carried to its section by the orbit's own sensitivities; no smoothed motion is integrated.

mod collect;
mod crossing;
mod doubt;
mod history;
mod layer;
mod prediction;
mod release;
mod response;
mod rubbing;
mod scalar;
mod shift;
mod virtual_field;

pub(super) use collect::predict;
pub use prediction::{Prediction, ReleaseLoss};
pub(super) use rubbing::Rubbed;

use crate::field::Smoothing;
use crate::field::exact::ContactError;
use crate::flow::FlowError;
use crate::integrate::IntegrationError;
use crate::model::{ContactId, brief};

/// Why no error can be predicted.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PredictError {
    /// The exact orbit never sticks.
    #[error("the exact orbit never sticks, so that no release makes an error of leading order")]
    NeverSticks,
    /// A contact presses and lets go.
    #[error("`{press}` presses and lets go: what its copy gets wrong is measured, not predicted")]
    Press {
        /// Which.
        press: &'static str,
    },
    /// The copy would still be creeping when the exact contact sticks again.
    #[error(
        "with `{smoothing}` contact {contact} would not let go before the exact one sticks again: far from the \
         asymptotic range"
    )]
    NeverReleased {
        /// Which.
        contact: ContactId,
        /// The smoothing.
        smoothing: Smoothing,
    },
    /// The exact orbit touches a surface, so that it has no derivative.
    #[error(
        "contact {contact} grazes at t = {} (rate {rate:.2e}): the orbit has no derivative there",
        brief(*.time)
    )]
    Grazing {
        /// Which.
        contact: ContactId,
        /// When.
        time: f64,
        /// Rate of the guard.
        rate: f64,
    },
    /// The orbit's shooting matrix is singular: it is at a fold.
    #[error("the orbit is at a fold: its response to a perturbation is not bounded")]
    Singular,
    /// The exact motion cannot be followed.
    #[error(transparent)]
    Flow(#[from] FlowError),
    /// The forces at rest are not determined.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// A scalar problem cannot be integrated.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
}
