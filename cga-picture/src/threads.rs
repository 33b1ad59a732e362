//! Work for all cores. The results do not depend on the number of threads.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

/// Runs `task` for the numbers below `count` and returns the results in order. Each thread has a state of its own, for
/// memory that is used again. A platform without threads does all the work here.
pub(crate) fn on_all_cores<S, T: Send>(
    count: usize,
    state: impl Fn() -> S + Sync,
    task: impl Fn(&mut S, usize) -> T + Sync,
) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let results = Mutex::new(Vec::with_capacity(count));
    let work = || {
        let mut state = state();
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if count <= number {
                break;
            }
            let result = task(&mut state, number);
            results.lock().unwrap_or_else(PoisonError::into_inner).push((number, result));
        }
    };
    let helpers = thread::available_parallelism().map_or(1, |cores| cores.get()).min(count).saturating_sub(1);
    thread::scope(|scope| {
        for _ in 0..helpers {
            // This thread does the work of those that cannot be started.
            if thread::Builder::new().spawn_scoped(scope, work).is_err() {
                break;
            }
        }
        work();
    });
    let mut results = results.into_inner().unwrap_or_else(PoisonError::into_inner);
    results.sort_unstable_by_key(|(number, _)| *number);
    results.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::on_all_cores;

    #[test]
    fn results_are_in_the_order_of_their_numbers() {
        for count in [0, 1, 100] {
            let squares = on_all_cores(count, Vec::new, |seen, number| {
                seen.push(number);
                number * number
            });
            assert_eq!(squares, (0..count).map(|number| number * number).collect::<Vec<_>>());
        }
    }
}
