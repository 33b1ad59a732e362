//! Work in parallel, results in order.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// The most jobs that begin while the result of an earlier one is not taken yet. So memory does not grow if one job takes long.
const MOST_AHEAD: usize = 128;

/// The results that wait for their turn.
struct Ready<T, F> {
    waiting: BTreeMap<usize, T>,
    take: F,
}

/// The next number in order, for a worker that looks for a job.
enum NextJob {
    Job(usize),
    /// The result of an earlier job has to be taken first.
    TooEarly,
    Nothing,
}

/// Does the jobs `0..count` and passes their results to `take` in the order of their numbers.
///
/// A job gets the state of its worker, its number, and a function that returns true if an earlier job has ended
/// everything. The second result of a job is true if the job ends everything itself: the results of later jobs are
/// then not taken. `first` is the state of the worker on the calling thread, and `again` makes the states of other
/// workers. On one thread, the jobs are done in order.
///
/// At most [`MOST_AHEAD`] results wait for an earlier one. A worker that would go further ends, as a thread that waits may hold up what is
/// below it on its stack. Another worker begins in its place as soon as results are taken.
pub(crate) fn in_order<W, T: Send>(
    count: usize,
    mut first: W,
    again: impl Fn() -> Option<W> + Sync,
    job: impl Fn(&mut W, usize, &dyn Fn() -> bool) -> (T, bool) + Sync,
    take: impl FnMut(T) + Send,
) {
    let (next_job, last_job, taken) = (AtomicUsize::new(0), AtomicUsize::new(usize::MAX), AtomicUsize::new(0));
    let ready = Mutex::new(Ready { waiting: BTreeMap::new(), take });
    let next = || {
        let mut number = next_job.load(Ordering::Relaxed);
        loop {
            if count <= number || last_job.load(Ordering::Relaxed) < number {
                return NextJob::Nothing;
            }
            if taken.load(Ordering::Relaxed) + MOST_AHEAD <= number {
                return NextJob::TooEarly;
            }
            match next_job.compare_exchange_weak(number, number + 1, Ordering::Relaxed, Ordering::Relaxed) {
                Ok(number) => return NextJob::Job(number),
                Err(other) => number = other,
            }
        }
    };
    // Does jobs until there is none that may begin. The result is true if there will be one.
    let work = |worker: &mut W, after_job: &dyn Fn(bool)| {
        loop {
            let number = match next() {
                NextJob::Job(number) => number,
                NextJob::TooEarly => return true,
                NextJob::Nothing => return false,
            };
            let ended = || last_job.load(Ordering::Relaxed) < number;
            let (result, ends) = job(worker, number, &ended);
            if ends {
                last_job.fetch_min(number, Ordering::Relaxed);
            }
            {
                let ready = &mut *ready.lock().unwrap_or_else(PoisonError::into_inner);
                ready.waiting.insert(number, result);
                let mut next = taken.load(Ordering::Relaxed);
                while next <= last_job.load(Ordering::Relaxed)
                    && let Some(result) = ready.waiting.remove(&next)
                {
                    (ready.take)(result);
                    next += 1;
                    taken.store(next, Ordering::Relaxed);
                }
            }
            let ahead = next_job.load(Ordering::Relaxed).saturating_sub(taken.load(Ordering::Relaxed));
            after_job(ahead <= MOST_AHEAD / 2);
        }
    };
    #[cfg(feature = "rayon")]
    {
        let others = rayon::current_num_threads().min(count).saturating_sub(1);
        if 0 < others {
            let crew = super::crew::Crew::new(&work, &again, others);
            // The calling thread works too, so the work is done even if all other threads are busy.
            rayon::in_place_scope(|scope| crew.work(&mut first, scope));
            return;
        }
    }
    #[cfg(not(feature = "rayon"))]
    let _ = again;
    // Each result is taken before the next job begins.
    work(&mut first, &|_| ());
}
