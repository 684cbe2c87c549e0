//! The items of a list, and which of them build on each other.

/// Items in rows: each item may build on those before it in its row, and on nothing else. Where no item builds on another,
/// each is a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rows {
    /// How many rows there are.
    pub count: usize,
    /// How many items each of them has.
    pub length: usize,
}

impl Rows {
    /// So many items that do not build on each other.
    #[must_use]
    pub const fn of(items: usize) -> Self {
        Self {
            count: items,
            length: 1,
        }
    }

    /// How many items there are in all, as far as they can be counted.
    #[must_use]
    pub const fn items(&self) -> usize {
        self.count.saturating_mul(self.length)
    }

    /// The items of a row.
    pub(super) fn row(&self, row: usize) -> std::ops::Range<usize> {
        row * self.length..(row + 1) * self.length
    }
}
