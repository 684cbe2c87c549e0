//! What a search for the least works on.

use std::ops::ControlFlow;

/// What is being looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Topic {
    /// The orbits.
    Orbits,
    /// The modes of structures.
    Modes,
    /// The contacts.
    Contacts,
    /// The parameters.
    Parameters,
    /// The smooth copies.
    Copies,
}

/// Told on what it works; a break ends it there.
pub(super) type Watch<'a> = &'a (dyn Fn(Topic) -> ControlFlow<()> + Sync);
