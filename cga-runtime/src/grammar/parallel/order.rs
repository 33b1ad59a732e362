//! Work in parallel, results in order.

use std::collections::BTreeMap;
#[cfg(feature = "rayon")]
use std::sync::atomic::AtomicBool;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// The results that wait for their turn, and the next number in order.
struct Ready<T, F> {
    waiting: BTreeMap<usize, T>,
    next: usize,
    take: F,
}

/// Does the jobs `0..count` and passes their results to `take` in the order of their numbers.
///
/// A job gets the state of its worker, its number, and a function that returns true if an earlier job has ended
/// everything. The second result of a job is true if the job ends everything itself: the results of later jobs are
/// then not taken. `first` is the state of the worker on the calling thread, and `again` makes the states of other
/// workers. On one thread, the jobs are done in order.
pub(crate) fn in_order<W, T: Send>(
    count: usize,
    mut first: W,
    again: impl Fn() -> Option<W> + Sync,
    job: impl Fn(&mut W, usize, &dyn Fn() -> bool) -> (T, bool) + Sync,
    take: impl FnMut(T) + Send,
) {
    let (next_job, last_job) = (AtomicUsize::new(0), AtomicUsize::new(usize::MAX));
    let ready = Mutex::new(Ready { waiting: BTreeMap::new(), next: 0, take });
    let work = |worker: &mut W| {
        loop {
            let number = next_job.fetch_add(1, Ordering::Relaxed);
            let ended = || last_job.load(Ordering::Relaxed) < number;
            if count <= number || ended() {
                break;
            }
            let (result, ends) = job(worker, number, &ended);
            if ends {
                last_job.fetch_min(number, Ordering::Relaxed);
            }
            let ready = &mut *ready.lock().unwrap_or_else(PoisonError::into_inner);
            ready.waiting.insert(number, result);
            while ready.next <= last_job.load(Ordering::Relaxed)
                && let Some(result) = ready.waiting.remove(&ready.next)
            {
                (ready.take)(result);
                ready.next += 1;
            }
        }
    };
    #[cfg(feature = "rayon")]
    {
        let others = rayon::current_num_threads().min(count).saturating_sub(1);
        if 0 < others {
            // A thread that waits inside a job, as sinks may, takes on other work. This must not be a second worker:
            // each may need a whole stack.
            let busy: Vec<AtomicBool> = (0..rayon::current_num_threads()).map(|_| AtomicBool::new(false)).collect();
            let begin = || {
                let place = rayon::current_thread_index().and_then(|index| busy.get(index));
                place.is_none_or(|busy| !busy.swap(true, Ordering::Relaxed))
            };
            // The calling thread works too, so the work is done even if all other threads are busy.
            rayon::in_place_scope(|scope| {
                begin();
                for _ in 0..others {
                    scope.spawn(|_| {
                        if begin()
                            && let Some(mut worker) = again()
                        {
                            work(&mut worker);
                        }
                    });
                }
                work(&mut first);
            });
            return;
        }
    }
    #[cfg(not(feature = "rayon"))]
    let _ = again;
    work(&mut first);
}
