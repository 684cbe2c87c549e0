//! What happened on a motion's way, and where it let go of a contact.

use std::ops::Range;

use crate::field::exact::Mode;
use crate::flow::EventKind;
use crate::motion::{Passage, sticking};
use crate::shooting::Shifts;

/// A contact that let go.
#[derive(Debug, Clone)]
pub(super) struct Release {
    pub(super) contact: usize,
    /// Of all contacts, afterwards.
    pub(super) modes: Vec<Mode>,
    /// The state, but for shifts that change nothing.
    pub(super) home: Vec<f64>,
    /// How many dimensions the states have at which this contact lets go out of these modes.
    pub(super) free: usize,
    /// How many switches had happened, this one among them.
    pub(super) after: usize,
}

impl Release {
    /// Whether the same contact let go, out of and into the same modes.
    pub(super) fn is_alike(&self, other: &Self) -> bool {
        let key = |release: &Self| (release.contact, release.free);
        key(self) == key(other) && self.modes == other.modes
    }
}

/// The switches of a motion, the first one first.
#[derive(Debug, Clone, Default)]
pub(super) struct Track {
    /// Contacts, and the modes into which they switched.
    pub(super) word: Vec<(usize, Mode)>,
    pub(super) releases: Vec<Release>,
}

impl Track {
    /// Goes on with a passage that begins in these modes, where these shifts change nothing; the places of its releases.
    pub(super) fn note(
        &mut self,
        passage: &Passage,
        mut modes: Vec<Mode>,
        shifts: &Shifts,
    ) -> Range<usize> {
        let known = self.releases.len();
        for event in passage.events.iter().filter(|event| event.switches()) {
            // What sticks has lost dimensions, and to be at the limit of what it bears takes one more.
            let bound = sticking(&modes) + 1;
            modes[event.contact] = event.mode;
            self.word.push((event.contact, event.mode));
            if matches!(event.kind, EventKind::Release { .. }) {
                self.releases.push(Release {
                    contact: event.contact,
                    modes: modes.clone(),
                    home: shifts.home(&event.state),
                    free: event.state.len().saturating_sub(bound),
                    after: self.word.len(),
                });
            }
        }
        known..self.releases.len()
    }
}
