//! Times of several implementations of the same work, best of many.

use std::time::{Duration, Instant};

/// The best time of each implementation. They run in turn, so that a change in the machine's load affects all
/// equally.
///
/// There are at least three rounds, and further rounds as long as `seconds` have not passed.
pub(crate) fn fastest<const N: usize>(seconds: f64, mut ways: [&mut dyn FnMut(); N]) -> [Duration; N] {
    let mut best = [Duration::MAX; N];
    let begin = Instant::now();
    let mut rounds = 0;
    while rounds < 3 || begin.elapsed().as_secs_f64() < seconds {
        for (way, best) in ways.iter_mut().zip(&mut best) {
            let start = Instant::now();
            way();
            *best = (*best).min(start.elapsed());
        }
        rounds += 1;
    }
    best
}

/// The nanoseconds for each of `count` items.
pub(crate) fn nanoseconds_each(time: Duration, count: usize) -> f64 {
    time.as_secs_f64() * 1e9 / count as f64
}
