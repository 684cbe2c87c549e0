//! Why forces at contacts are not determined.

use super::affine::Square;
use super::mode::Modes;
use crate::model::{ContactId, Model, brief, listed};

/// Why the forces at rest are not determined.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ContactError {
    /// Several contacts resist the same motion, or a force does not act on any speed.
    #[error(
        "the forces at rest of contacts {} are not unique: together they hold one and the same motion; contacts with the same relative speed can be written as one, and where friction acts along the way of several presses that do not give way, or grows with the reaction along its own way, a stiff `Compliant` press shares the load",
        listed(.contacts)
    )]
    Singular {
        /// The contacts that would stick together.
        contacts: Vec<ContactId>,
    },
    /// G_ii ≤ 0: a sign error in the model.
    #[error(
        "the force of contact {contact} does not oppose its speed: a unit force changes it at the rate {}; where that is meant, as of a relay, a smooth copy knows what to do",
        brief(*.compliance)
    )]
    NotOpposing {
        /// Which.
        contact: ContactId,
        /// G_ii, which should be positive.
        compliance: f64,
    },
    /// Sliding friction turns the reaction that causes it around.
    #[error(
        "no reaction keeps contact {contact} closed while it slides: with the friction that it causes, a unit of it changes the rate of the gap by {}, which Painlevé's condition wants above 0",
        brief(*.compliance)
    )]
    Painleve {
        /// The press.
        contact: ContactId,
        /// What a unit reaction and its friction do to the rate of the gap.
        compliance: f64,
    },
    /// Friction that is not proportional to a reaction, up to a constant.
    #[error(
        "the friction of contact {contact} does not grow in proportion to the reaction of contact {press}, which does not give way: that is solved for by linear equations, and `level: mu * N` is a law that it can be solved with"
    )]
    Bent {
        /// Which.
        contact: ContactId,
        /// The press.
        press: ContactId,
    },
}

/// The forces of the sticking contacts must oppose their speeds: G_ii > 0.
pub(super) fn opposing<M: Model<N>, const N: usize>(
    compliance: &Square<M, f64, N>,
    modes: &Modes<M, N>,
) -> Result<(), ContactError> {
    for contact in modes.bound() {
        let compliance = compliance.as_ref()[contact].as_ref()[contact];
        if compliance <= 0.0 {
            if M::INFO
                .rubs_under(contact)
                .any(|i| modes.as_slice()[i].sign() != 0.0)
            {
                return Err(ContactError::Painleve {
                    contact: M::INFO.contact_id(contact),
                    compliance,
                });
            }
            return Err(ContactError::NotOpposing {
                contact: M::INFO.contact_id(contact),
                compliance,
            });
        }
    }
    Ok(())
}

pub(super) fn singular<M: Model<N>, const N: usize>(modes: &Modes<M, N>) -> ContactError {
    ContactError::Singular {
        contacts: modes.bound().map(|i| M::INFO.contact_id(i)).collect(),
    }
}
