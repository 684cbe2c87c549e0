//! What changes at an event.

use crate::field::exact::Mode;
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

    /// That of an impact after which contacts slide the other way, and nothing else has changed: their speeds vanish with its
    /// own, as that of a mass on the ground that meets a wall.
    pub(super) fn turning(modes: [&Modes; 2], impact: usize) -> Option<Self> {
        let pairs = modes[0].iter().zip(modes[1]);
        let mut changed = pairs.filter(|(before, after)| before != after).peekable();
        changed.peek()?;
        let turn = changed.all(|(before, after)| {
            matches!(
                (before, after),
                (Mode::SlideForward, Mode::SlideBackward)
                    | (Mode::SlideBackward, Mode::SlideForward)
            )
        });
        turn.then(|| Self::at_once(modes.map(Clone::clone), vec![impact]))
    }
}
