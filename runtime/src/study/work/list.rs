//! A list of items, done on all cores.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use super::parallel::parallel_on;
use super::rows::Rows;
use super::share::Share;

/// Which items of a list are to be done, and what is known of them.
#[derive(Debug, Clone)]
pub struct List<T> {
    /// Which of them are done here.
    pub share: Share,
    /// On so many threads, or on all cores.
    pub threads: Option<usize>,
    /// What earlier runs of the same list have left, by number.
    pub known: BTreeMap<usize, T>,
    /// Whether nothing is done beyond what is known.
    pub closed: bool,
}

/// An item that is there.
#[derive(Debug)]
pub struct Item<'a, T> {
    /// Its number.
    pub number: usize,
    /// What was found.
    pub found: &'a T,
    /// Whether it was known before.
    pub known: bool,
    /// The share of the work that is done.
    pub done: f64,
}

/// Told of each item of a list, from any thread; a break ends the work there.
pub type Watch<'a, T> = &'a (dyn Fn(Item<'_, T>) -> ControlFlow<()> + Sync);

impl<T> Default for List<T> {
    /// All items, of which nothing is known, on all cores.
    fn default() -> Self {
        Self {
            share: Share::WHOLE,
            threads: None,
            known: BTreeMap::new(),
            closed: false,
        }
    }
}

impl<T> List<T> {
    /// All items, of which nothing is known, one after the other: where times are measured, or other threads are at work.
    #[must_use]
    pub fn on_one_thread() -> Self {
        Self {
            threads: Some(1),
            ..Self::default()
        }
    }
}

impl<T: Clone + Send + Sync> List<T> {
    /// Does what is not known yet of so many independent items. What is there then, by number.
    pub fn work(
        &self,
        items: usize,
        one: impl Fn(usize) -> T + Sync,
        watch: Watch<'_, T>,
    ) -> BTreeMap<usize, T> {
        let item = |_: &mut (), number, known: Option<T>| known.unwrap_or_else(|| one(number));
        self.work_in_rows(Rows::of(items), || (), item, watch)
    }

    /// Does what is not known yet, row by row. `one` finds an item or takes the one that is known, and what it `begin`s each
    /// row with it hands on to the next item of the row. What is there then, by number.
    pub fn work_in_rows<H>(
        &self,
        rows: Rows,
        begin: impl Fn() -> H + Sync,
        one: impl Fn(&mut H, usize, Option<T>) -> T + Sync,
        watch: Watch<'_, T>,
    ) -> BTreeMap<usize, T> {
        let numbers: Vec<usize> = self.share.rows(rows).collect();
        let all = self.share.count(rows) as f64;
        let (done, stopped) = (AtomicUsize::new(0), AtomicBool::new(false));
        let item = |hand: &mut H, number: usize| {
            let old = self.known.get(&number);
            let known = old.is_some();
            if stopped.load(Ordering::Relaxed) || (self.closed && !known) {
                return None;
            }
            let found = one(hand, number, old.cloned());
            let count = done.fetch_add(1, Ordering::Relaxed) + 1;
            let verdict = watch(Item {
                number,
                found: &found,
                known,
                done: count as f64 / all,
            });
            if verdict.is_break() {
                stopped.store(true, Ordering::Relaxed);
            }
            Some((number, found))
        };
        let row = |&row: &usize| {
            let mut hand = begin();
            let items = rows.row(row).map(|number| item(&mut hand, number));
            items.map_while(|found| found).collect::<Vec<_>>()
        };
        let found = parallel_on(self.threads, &numbers, row);
        found.into_iter().flatten().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Seven rows, each item of which is the sum of what is before it in the row and its own square.
    const ROWS: Rows = Rows {
        count: 7,
        length: 14,
    };

    fn go_on(_: Item<'_, usize>) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    fn list(share: Share, known: BTreeMap<usize, usize>) -> List<usize> {
        List {
            share,
            threads: Some(3),
            known,
            closed: false,
        }
    }

    fn sums(list: &List<usize>, watch: Watch<'_, usize>) -> BTreeMap<usize, usize> {
        let one = |sum: &mut usize, number: usize, known: Option<usize>| {
            *sum = known.unwrap_or(*sum + number * number);
            *sum
        };
        list.work_in_rows(ROWS, || 0, one, watch)
    }

    #[test]
    fn shares_and_interruptions_add_up_to_the_whole() {
        let whole = sums(&list(Share::WHOLE, BTreeMap::new()), &go_on);
        assert_eq!((whole.len(), whole[&15]), (98, 14 * 14 + 15 * 15));
        let mut known = BTreeMap::new();
        for number in [3, 1, 2] {
            let share = Share::new(number, 3).unwrap();
            let cut = |item: Item<'_, usize>| match item.number % 14 > 5 {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            };
            let part = sums(&list(share, known.clone()), &cut);
            assert!(part.len() < share.count(ROWS), "{}", part.len());
            known.extend(sums(&list(share, part), &go_on));
        }
        let merged = List {
            closed: true,
            ..list(Share::WHOLE, known)
        };
        assert_eq!(sums(&merged, &go_on), whole);
    }

    #[test]
    fn nothing_known_is_done_again() {
        let known = (0..100).map(|number| (number, 7)).collect();
        let again = list(Share::WHOLE, known).work(100, |_| 0, &go_on);
        assert!(again.values().all(|found| *found == 7));
    }
}
