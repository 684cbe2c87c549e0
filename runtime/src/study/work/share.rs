//! A share of a list.

use std::fmt;

use super::rows::Rows;

/// Every so many-th row of a list: the costs of neighbours are alike, and so are those of the shares.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Share {
    number: usize,
    of: usize,
}

impl Share {
    /// The whole list.
    pub const WHOLE: Self = Self { number: 1, of: 1 };

    /// Share number `number`, counted from 1, of `of`; `None` if there is no such share.
    #[must_use]
    pub fn new(number: usize, of: usize) -> Option<Self> {
        (1..=of).contains(&number).then_some(Self { number, of })
    }

    /// Its number, counted from 1.
    #[must_use]
    pub const fn number(&self) -> usize {
        self.number
    }

    /// How many shares there are.
    #[must_use]
    pub const fn of(&self) -> usize {
        self.of
    }

    /// The numbers of its rows.
    pub(super) fn rows(&self, rows: Rows) -> impl Iterator<Item = usize> + use<> {
        (self.number - 1..rows.count).step_by(self.of)
    }

    /// Its items of a list.
    pub fn items(&self, rows: Rows) -> impl Iterator<Item = usize> + use<> {
        self.rows(rows).flat_map(move |row| rows.row(row))
    }

    /// How many items it has.
    #[must_use]
    pub const fn count(&self, rows: Rows) -> usize {
        let from = rows.count.saturating_sub(self.number - 1);
        from.div_ceil(self.of).saturating_mul(rows.length)
    }
}

impl fmt::Display for Share {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_disjoint_and_leave_nothing_out() {
        for of in [1, 2, 7, 30] {
            let shares = (1..=of).filter_map(|number| Share::new(number, of));
            for rows in [
                Rows::of(23),
                Rows {
                    count: 5,
                    length: 4,
                },
            ] {
                let items = |share: Share| {
                    let items: Vec<usize> = share.items(rows).collect();
                    assert_eq!(items.len(), share.count(rows));
                    items
                };
                let mut all: Vec<usize> = shares.clone().flat_map(items).collect();
                all.sort_unstable();
                assert_eq!(all, (0..rows.items()).collect::<Vec<_>>());
            }
        }
        assert_eq!((Share::new(0, 3), Share::new(4, 3)), (None, None));
    }
}
