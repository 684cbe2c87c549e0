//! Why a motion has no derivative at an event.

use crate::model::{ContactId, brief, listed};

/// Why a motion has no derivative at an event; the motion itself goes on.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SensitivityUndefined {
    /// The event surface is touched, not crossed.
    #[error(
        "no derivative: contact {contact} grazes at t = {}, where its guard falls at the rate {rate:.2e} only",
        brief(*.time)
    )]
    Grazing {
        /// Which.
        contact: ContactId,
        /// When.
        time: f64,
        /// Rate of the guard along the motion.
        rate: f64,
    },
    /// Events at one time whose order matters.
    #[error(
        "no derivative: contacts {} switch together at t = {}, and their order matters",
        listed(.contacts),
        brief(*.time)
    )]
    Simultaneous {
        /// Which.
        contacts: Vec<ContactId>,
        /// When.
        time: f64,
    },
}
