//! A list of items, done on all cores.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use super::parallel::parallel_on;
use super::share::Share;

/// Which items are to be done, and what is known of them.
#[derive(Debug, Clone)]
pub struct List<T> {
    /// How many items there are in all.
    pub count: usize,
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

impl<T> List<T> {
    /// All of so many items, of which nothing is known.
    #[must_use]
    pub fn whole(count: usize) -> Self {
        Self {
            count,
            share: Share::WHOLE,
            threads: None,
            known: BTreeMap::new(),
            closed: false,
        }
    }
}

impl<T: Clone + Send + Sync> List<T> {
    /// Does what is not known yet; `watch` is told of each item, from any thread, and may end the work there. What is
    /// there then, by number.
    pub fn work(
        &self,
        one: impl Fn(usize) -> T + Sync,
        watch: &(dyn Fn(Item<'_, T>) -> ControlFlow<()> + Sync),
    ) -> BTreeMap<usize, T> {
        let numbers: Vec<usize> = self.share.items(self.count).collect();
        let (done, stopped) = (AtomicUsize::new(0), AtomicBool::new(false));
        let item = |&number: &usize| {
            if stopped.load(Ordering::Relaxed) {
                return None;
            }
            let known = self.known.get(&number);
            if known.is_none() && self.closed {
                return None;
            }
            let found = known.cloned().unwrap_or_else(|| one(number));
            let count = done.fetch_add(1, Ordering::Relaxed) + 1;
            let verdict = watch(Item {
                number,
                found: &found,
                known: known.is_some(),
                done: count as f64 / numbers.len() as f64,
            });
            if verdict.is_break() {
                stopped.store(true, Ordering::Relaxed);
            }
            Some((number, found))
        };
        let found = parallel_on(self.threads, &numbers, item);
        found.into_iter().flatten().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn list(share: Share, known: BTreeMap<usize, usize>) -> List<usize> {
        List {
            count: 100,
            share,
            threads: Some(3),
            known,
            closed: false,
        }
    }

    #[test]
    fn shares_and_interruptions_add_up_to_the_whole() {
        let square = |number| number * number;
        let go_on = |_: Item<'_, usize>| ControlFlow::Continue(());
        let whole = list(Share::WHOLE, BTreeMap::new()).work(square, &go_on);
        let mut known = BTreeMap::new();
        for number in [3, 1, 2] {
            let share = Share::new(number, 3).unwrap();
            let cut = |item: Item<'_, usize>| match item.number > 50 {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            };
            let part = list(share, known.clone()).work(square, &cut);
            assert!(part.len() < 34, "{}", part.len());
            known.extend(list(share, part).work(square, &go_on));
        }
        let merged = List {
            closed: true,
            ..list(Share::WHOLE, known)
        };
        assert_eq!(merged.work(|_| 0, &go_on), whole);
    }

    #[test]
    fn nothing_known_is_done_again() {
        let known = (0..100).map(|number| (number, 7)).collect();
        let again = list(Share::WHOLE, known).work(|_| 0, &|_| ControlFlow::Continue(()));
        assert!(again.values().all(|found| *found == 7));
    }
}
