//! Progress and cancellation of runs.
//!
//! A [`Watch`] is shared by a program and its runs, on any number of threads. A run asks it every [`STRIDE`] derived shapes
//! or function calls, before every operation on geometry, inside the long ones, and when it begins and ends. Shapes that
//! only split pay nothing for it: their counter passes a checkpoint, and without a watch the checkpoint is the limit itself.

use std::fmt;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, TryLockError};
use std::time::Duration;

use crate::run::sink::Flow;

/// The number of derived shapes, or of function calls, between two checks of the watch.
pub const STRIDE: u64 = 16_384;

/// The progress of all runs with one [`Watch`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Progress {
    /// Initial shapes whose runs are complete.
    pub initial_shapes: u64,
    /// Shapes derived, leaves included.
    pub shapes: u64,
    /// Leaves passed to sinks.
    pub leaves: u64,
    /// The work of operations on geometry, in units of some nanoseconds each. It is told in steps of some ten thousand units, so
    /// runs of small operations may tell none.
    pub work: u64,
}

/// Follows the progress of runs and ends them early. Copies are the same watch.
///
/// Put it into [`Settings::watch`](crate::run::settings::Settings::watch). It works for single runs, for sessions and
/// for parallel runs.
///
/// ```
/// # use cga_runtime::facade as cga;
/// use cga::{Settings, Watch};
///
/// let watch = Watch::new();
/// let settings = Settings { watch: Some(watch.clone()), ..Settings::default() };
/// // Runs with `settings` end as soon as another thread, or a sink, calls this:
/// watch.stop();
/// assert!(watch.is_stopped() && settings.watch.is_some_and(|watch| watch.is_stopped()));
/// ```
#[derive(Clone, Default)]
pub struct Watch {
    shared: Arc<WatchState>,
}

type Callback = Box<dyn FnMut(Progress) -> Flow + Send>;

#[derive(Default)]
struct WatchState {
    stopped: AtomicBool,
    initial_shapes: AtomicU64,
    shapes: AtomicU64,
    leaves: AtomicU64,
    work: AtomicU64,
    callback: Option<(u64, Mutex<Callback>)>,
    deadline: Option<Deadline>,
}

/// A time at which runs end, on a clock.
struct Deadline {
    at: Duration,
    clock: Box<dyn Fn() -> Duration + Send + Sync>,
}

impl fmt::Debug for Watch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Watch").field("progress", &self.progress()).field("stopped", &self.is_stopped()).finish()
    }
}

impl Watch {
    /// A watch without a callback. Its [`progress`](Watch::progress) can be read at any time.
    pub fn new() -> Self {
        Watch::default()
    }

    /// A watch that calls `callback` every `shapes` derived shapes, on the thread of a run. `Break` ends all runs.
    ///
    /// A run checks its watch every [`STRIDE`] shapes, so calls come at those steps. Calls never overlap: while one
    /// lasts, others are left out.
    ///
    /// ```
    /// use std::ops::ControlFlow;
    ///
    /// # use cga_runtime::facade as cga;
    /// use cga::Watch;
    ///
    /// let watch = Watch::every(1_000_000, |progress| {
    ///     eprintln!("{} lots, {} parts", progress.initial_shapes, progress.leaves);
    ///     if progress.leaves < 100_000_000 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    /// });
    /// assert_eq!(watch.progress().leaves, 0);
    /// ```
    pub fn every(shapes: u64, callback: impl FnMut(Progress) -> Flow + Send + 'static) -> Self {
        let callback: Callback = Box::new(callback);
        Watch {
            shared: Arc::new(WatchState {
                callback: Some((shapes.max(1), Mutex::new(callback))),
                ..WatchState::default()
            }),
        }
    }

    /// A watch that ends all runs when `limit` has passed since this call. A run returns soon after
    /// that time, usually within some tens of milliseconds, with `stopped` set in its report. What it has made by then depends on the speed of the machine.
    ///
    /// ```
    /// use std::time::Duration;
    ///
    /// # use cga_runtime::facade as cga;
    /// use cga::Watch;
    ///
    /// let watch = Watch::deadline(Duration::from_secs(5));
    /// assert!(!watch.is_stopped());
    /// ```
    #[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
    pub fn deadline(limit: Duration) -> Self {
        let start = std::time::Instant::now();
        Watch::deadline_by(limit, move || start.elapsed())
    }

    /// As [`deadline`](fn@Watch::deadline), with a clock of the caller: in a browser, where the standard library has none,
    /// or in a game, whose time can stand still. The clock returns the time since any start. Runs call it often, on their
    /// threads.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use std::sync::atomic::{AtomicU64, Ordering};
    /// use std::time::Duration;
    ///
    /// # use cga_runtime::facade as cga;
    /// use cga::Watch;
    ///
    /// let frame = Arc::new(AtomicU64::new(0));
    /// let clock = frame.clone();
    /// let watch = Watch::deadline_by(Duration::from_millis(30), move || {
    ///     Duration::from_millis(16 * clock.load(Ordering::Relaxed))
    /// });
    /// frame.store(1, Ordering::Relaxed);
    /// assert!(!watch.is_stopped());
    /// frame.store(2, Ordering::Relaxed);
    /// assert!(watch.is_stopped());
    /// ```
    pub fn deadline_by(limit: Duration, clock: impl Fn() -> Duration + Send + Sync + 'static) -> Self {
        let at = clock().saturating_add(limit);
        let deadline = Some(Deadline { at, clock: Box::new(clock) });
        Watch { shared: Arc::new(WatchState { deadline, ..WatchState::default() }) }
    }

    /// Ends all runs with this watch soon. Each returns a report with `stopped` set. Later runs end before they
    /// begin.
    pub fn stop(&self) {
        self.shared.stopped.store(true, Ordering::Relaxed);
    }

    /// Returns true if [`stop`](Watch::stop) was called, the callback returned `Break`, or the deadline has passed. It then
    /// stays true.
    pub fn is_stopped(&self) -> bool {
        if self.shared.stopped.load(Ordering::Relaxed) {
            return true;
        }
        let has_passed = self.shared.deadline.as_ref().is_some_and(|deadline| deadline.at <= (deadline.clock)());
        if has_passed {
            self.stop();
        }
        has_passed
    }

    /// The progress of the runs, as of their last checks.
    pub fn progress(&self) -> Progress {
        let read = |counter: &AtomicU64| counter.load(Ordering::Relaxed);
        Progress {
            initial_shapes: read(&self.shared.initial_shapes),
            shapes: read(&self.shared.shapes),
            leaves: read(&self.shared.leaves),
            work: read(&self.shared.work),
        }
    }

    /// Adds units of work. Returns true if it goes on.
    pub(crate) fn allows(&self, units: u64) -> bool {
        self.shared.work.fetch_add(units, Ordering::Relaxed);
        !self.is_stopped()
    }

    /// Adds the progress of a run since its last report.
    pub(super) fn advance(&self, more: Progress) {
        let add = |counter: &AtomicU64, more: u64| counter.fetch_add(more, Ordering::Relaxed);
        add(&self.shared.initial_shapes, more.initial_shapes);
        add(&self.shared.leaves, more.leaves);
        let before = add(&self.shared.shapes, more.shapes);
        let Some((every, callback)) = &self.shared.callback else { return };
        if before / every == before.saturating_add(more.shapes) / every || self.is_stopped() {
            return;
        }
        let mut callback = match callback.try_lock() {
            Ok(callback) => callback,
            Err(TryLockError::Poisoned(poisoned)) => poisoned.into_inner(),
            // Also if the callback itself runs a grammar.
            Err(TryLockError::WouldBlock) => return,
        };
        if callback(self.progress()).is_break() {
            self.stop();
        }
    }
}
