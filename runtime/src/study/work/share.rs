//! A share of a list.

use std::fmt;

/// Every so many-th item of a list: the costs of neighbours are alike, and so are those of the shares.
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

    /// Its items of a list of `count`.
    pub fn items(&self, count: usize) -> impl Iterator<Item = usize> + use<> {
        (self.number - 1..count).step_by(self.of)
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
            let mut all: Vec<usize> = shares.flat_map(|share| share.items(23)).collect();
            all.sort_unstable();
            assert_eq!(all, (0..23).collect::<Vec<_>>());
        }
        assert_eq!((Share::new(0, 3), Share::new(4, 3)), (None, None));
    }
}
