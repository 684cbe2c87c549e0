//! What happens at the contacts of an exact system.

use serde::{Deserialize, Serialize};

/// What can happen at a contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum EventKind {
    /// It came to rest and sticks.
    Landing {
        /// How far the sticking force is from the limit: stick − |λ|.
        margin: f64,
        /// It might also have crossed: slip(0⁺) < |λ| against the old motion.
        ambiguous: bool,
    },
    /// It stopped and went on in the other direction.
    Crossing {
        /// How far the force that could have held it lies beyond the limit: |λ| − stick.
        margin: f64,
        /// It might also have stuck.
        ambiguous: bool,
    },
    /// It broke loose.
    Release {
        /// Others were as near to their limits: the lowest number was chosen.
        tied: bool,
    },
    /// A gap closed, and the contact presses.
    Closing,
    /// The force of a contact that pressed has fallen to zero, and it is open.
    Opening,
    /// A gap that does not give way closed, and opens again.
    Impact {
        /// Speed at which it closed.
        approach: f64,
        /// Speed at which it opens.
        departure: f64,
    },
    /// Impacts that follow each other ever faster came to their end, all that were left at once; the contact stays closed.
    Settled {
        /// Speed at which the gap closed the last time that was seen.
        approach: f64,
        /// For how long the others go on.
        lasts: f64,
    },
    /// It came nearest to an event that did not happen: a local minimum of |w|, of stick − |λ|, or of a gap.
    Nearest {
        /// That minimum.
        margin: f64,
    },
}

impl EventKind {
    /// Whether the mode of the contact changes.
    #[must_use]
    pub fn is_switch(&self) -> bool {
        !matches!(self, Self::Nearest { .. })
    }
}
