//! Values of a diagram that are there already.

use std::collections::HashMap;

use super::slice::Slice;

/// What an interrupted diagram has left: its values, from which it goes on as if it had never ended.
#[derive(Debug, Clone, Default)]
pub struct Known(HashMap<(String, u64), Slice>);

impl Known {
    /// Takes in a value of a sweep of this name.
    pub fn insert(&mut self, sweep: &str, slice: Slice) {
        self.0.insert((sweep.to_owned(), slice.r.to_bits()), slice);
    }

    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The value of a sweep at r, in the user's own values.
    pub(super) fn get(&self, sweep: &str, r: f64) -> Option<Slice> {
        self.0.get(&(sweep.to_owned(), r.to_bits())).cloned()
    }
}
