//! Independent computations on all cores.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::Builder;

/// Bytes of stack of each thread, as for the whole program: large models need them, and what is not used is never touched.
const STACK: usize = 256 << 20;

/// Maps on all available cores. Results keep the order of `items`, whatever the number of cores.
pub fn parallel<T: Sync, R: Send>(items: &[T], f: impl Fn(&T) -> R + Sync) -> Vec<R> {
    parallel_on(None, items, f)
}

/// Maps on this many threads, or on all available cores.
pub fn parallel_on<T: Sync, R: Send>(
    threads: Option<usize>,
    items: &[T],
    f: impl Fn(&T) -> R + Sync,
) -> Vec<R> {
    let all = || std::thread::available_parallelism().map_or(1, usize::from);
    let cores = threads.unwrap_or_else(all).max(1);
    let next = AtomicUsize::new(0);
    let worker = || {
        let mut done = Vec::new();
        loop {
            let i = next.fetch_add(1, Ordering::Relaxed);
            match items.get(i) {
                Some(item) => done.push((i, f(item))),
                None => return done,
            }
        }
    };
    let mut all: Vec<(usize, R)> = std::thread::scope(|scope| {
        let begin = |_| Builder::new().stack_size(STACK).spawn_scoped(scope, worker);
        let workers: Vec<_> = (0..cores.min(items.len()))
            .filter_map(|k| begin(k).ok())
            .collect();
        if workers.is_empty() {
            return worker();
        }
        workers
            .into_iter()
            .flat_map(|handle| match handle.join() {
                Ok(done) => done,
                Err(panic) => std::panic::resume_unwind(panic),
            })
            .collect()
    });
    all.sort_by_key(|(i, _)| *i);
    all.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    #[test]
    fn order_is_kept() {
        let items: Vec<u64> = (0..100).collect();
        let squares = super::parallel(&items, |x| x * x);
        assert!(squares.iter().zip(&items).all(|(s, x)| *s == x * x));
    }
}
