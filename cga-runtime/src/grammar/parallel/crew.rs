//! The workers of `in_order` on the threads of rayon.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use rayon::Scope;

/// Does jobs until there is none that may begin. Calls the function after each job; its argument is true if several jobs may begin.
/// The result is true if other jobs may begin later.
type Work<'a, W> = &'a (dyn Fn(&mut W, &dyn Fn(bool)) -> bool + Sync);

/// Workers that begin, end early and begin again.
pub(super) struct Crew<'a, W> {
    work: Work<'a, W>,
    again: &'a (dyn Fn() -> Option<W> + Sync),
    /// The threads that have a worker. A thread that waits inside a job, as sinks may, takes on other work. This must not be a second
    /// worker: each may need a whole stack.
    busy: Vec<AtomicBool>,
    /// The number of workers that have not begun, or have ended early.
    idle: AtomicUsize,
}

impl<'a, W> Crew<'a, W> {
    /// A crew with a number of workers beside the one on the calling thread.
    pub(super) fn new(work: Work<'a, W>, again: &'a (dyn Fn() -> Option<W> + Sync), others: usize) -> Self {
        let busy = (0..rayon::current_num_threads()).map(|_| AtomicBool::new(false)).collect();
        Crew { work, again, busy, idle: AtomicUsize::new(others) }
    }

    /// Begins all workers, and works on the calling thread.
    pub(super) fn work<'s>(&'s self, first: &mut W, scope: &Scope<'s>) {
        let place = self.place();
        place.iter().for_each(|busy| busy.store(true, Ordering::Relaxed));
        self.begin_idle(scope);
        self.work_as(first, scope);
        place.iter().for_each(|busy| busy.store(false, Ordering::Relaxed));
    }

    /// The mark of the current thread; `None` outside of the pool.
    fn place(&self) -> Option<&AtomicBool> {
        rayon::current_thread_index().and_then(|index| self.busy.get(index))
    }

    fn work_as<'s>(&'s self, worker: &mut W, scope: &Scope<'s>) {
        // Workers begin when there are several jobs for them, as the state of a worker takes time.
        let after_job = |has_jobs: bool| {
            if has_jobs {
                self.begin_idle(scope);
            }
        };
        if (self.work)(worker, &after_job) {
            self.idle.fetch_add(1, Ordering::Relaxed);
        }
    }

    fn begin_idle<'s>(&'s self, scope: &Scope<'s>) {
        (0..self.idle.swap(0, Ordering::Relaxed)).for_each(|_| self.begin(scope));
    }

    fn begin<'s>(&'s self, scope: &Scope<'s>) {
        scope.spawn(move |scope| {
            let place = self.place();
            if place.is_some_and(|busy| busy.swap(true, Ordering::Relaxed)) {
                return;
            }
            if let Some(mut worker) = (self.again)() {
                self.work_as(&mut worker, scope);
            }
            place.iter().for_each(|busy| busy.store(false, Ordering::Relaxed));
        });
    }
}
