//! Best of many.

use std::time::{Duration, Instant};

/// Seconds that the fastest of the runs takes that fit into `patience`, at least three.
pub(crate) fn best(patience: Duration, mut run: impl FnMut()) -> f64 {
    let begin = Instant::now();
    let (mut fastest, mut runs) = (f64::INFINITY, 0);
    while runs < 3 || begin.elapsed() < patience {
        let start = Instant::now();
        run();
        fastest = fastest.min(start.elapsed().as_secs_f64());
        runs += 1;
    }
    fastest
}
