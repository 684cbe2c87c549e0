//! Places where contacts let go, whose future is known.

use crate::field::exact::Mode;
use crate::flow::EventKind;
use crate::motion::{Event, Passage, apart};

/// States that agree to this, in usual sizes, are the same but for rounding.
const SAME: f64 = 1e-10;
/// Most places that are kept.
const MOST: usize = 256;

/// Where motions have let go of a contact, and on what they settled.
///
/// What sticks loses a dimension, and of a single mass all that it had: all motions that stick let go at one place, and
/// all that let go there share one future.
#[derive(Debug, Clone, Default)]
pub(super) struct Memo(Vec<Release>);

#[derive(Debug, Clone)]
struct Release {
    contact: usize,
    mode: Mode,
    state: Vec<f64>,
    of: usize,
}

impl Memo {
    /// Told of the releases of a motion that settles on motion number `of`.
    pub(super) fn learn(&mut self, passages: &[Passage], of: usize, usual: &[f64]) {
        for event in passages.iter().flat_map(releases) {
            if self.0.len() < MOST && self.release(event, usual).is_none() {
                self.0.push(Release {
                    contact: event.contact,
                    mode: event.mode,
                    state: event.state.clone(),
                    of,
                });
            }
        }
    }

    /// On what a motion settles that lets go like this, if that is known.
    pub(super) fn future(&self, passage: &Passage, usual: &[f64]) -> Option<usize> {
        releases(passage).find_map(|event| self.release(event, usual))
    }

    fn release(&self, event: &Event, usual: &[f64]) -> Option<usize> {
        let known = self.0.iter().find(|known| {
            known.contact == event.contact
                && known.mode == event.mode
                && apart(&known.state, &event.state, usual) <= SAME
        });
        known.map(|known| known.of)
    }
}

fn releases(passage: &Passage) -> impl Iterator<Item = &Event> {
    let events = passage.events.iter();
    events.filter(|event| matches!(event.kind, EventKind::Release { .. }))
}
