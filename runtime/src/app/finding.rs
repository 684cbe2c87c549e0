//! What is found of the items of a list, and what is known of it already.

use std::collections::BTreeMap;

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::study::trade::Part;
use crate::study::{Cell, Fate, Rows, Slice};

/// What is found of an item of a list.
pub(super) trait Finding: Serialize + DeserializeOwned + Clone + Send + Sync {
    /// Whether it can belong to a system with so many states.
    fn is_of(&self, _order: usize) -> bool {
        true
    }

    /// The same without what differs from run to run.
    fn lasting(&self) -> Self {
        self.clone()
    }

    /// Whether two runs have found the same.
    fn agrees(&self, other: &Self) -> bool {
        let bytes = |one: &Self| postcard::to_allocvec(&one.lasting());
        bytes(self) == bytes(other)
    }
}

impl Finding for Fate {}

impl Finding for Cell {}

impl Finding for Slice {
    fn is_of(&self, order: usize) -> bool {
        Self::is_of(self, order)
    }
}

impl Finding for Part {
    fn is_of(&self, order: usize) -> bool {
        Self::is_of(self, order)
    }

    fn lasting(&self) -> Self {
        self.timeless()
    }
}

/// What is known of a list.
pub(super) struct Known<T> {
    items: usize,
    order: usize,
    /// What was found, by number.
    pub(super) found: BTreeMap<usize, T>,
}

impl<T: Finding> Known<T> {
    /// Nothing of such a list about a system with so many states.
    pub(super) const fn of(rows: Rows, order: usize) -> Self {
        Self {
            items: rows.items(),
            order,
            found: BTreeMap::new(),
        }
    }

    /// Takes in what was noted of an item, unless it is there; its number, and whether it is what is there. `None` if it
    /// makes no sense.
    pub(super) fn take(&mut self, finding: &[u8]) -> Option<(usize, bool)> {
        let (number, found): (usize, T) = postcard::from_bytes(finding).ok()?;
        if number >= self.items || !found.is_of(self.order) {
            return None;
        }
        let agrees = match self.found.get(&number) {
            Some(old) => old.agrees(&found),
            None => {
                self.found.insert(number, found);
                true
            }
        };
        Some((number, agrees))
    }
}
