//! What changes at an event.

use crate::motion::Modes;

/// The change at an event: what comes next, if that belongs to it.
pub(super) struct Change {
    pub(super) modes: [Modes; 2],
    /// By which switches the words on both sides of it differ.
    pub(super) own: Vec<usize>,
    /// How many of them happen at once at the border: where friction drops, the first one only.
    pub(super) at_once: usize,
}

impl Change {
    /// All of whose switches happen at once.
    pub(super) fn at_once(modes: [Modes; 2], own: Vec<usize>) -> Self {
        let at_once = own.len();
        Self {
            modes,
            own,
            at_once,
        }
    }
}
