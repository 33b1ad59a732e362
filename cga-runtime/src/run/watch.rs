//! Progress and cancellation of runs.
//!
//! A [`Watch`] is shared by a program and its runs, on any number of threads. A run asks it each [`STRIDE`] shapes or calls of
//! functions that it makes, and when it begins and ends. The question costs the hot path nothing: it is asked where the
//! counter of shapes passes a checkpoint, and without a watch the checkpoint is the limit itself.

use std::fmt;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, TryLockError};

use crate::run::sink::Flow;

/// Shapes that a run derives, or calls of functions that it makes, between two questions to its watch.
pub const STRIDE: u64 = 16_384;

/// How far all runs with one [`Watch`] have come.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Progress {
    /// Initial shapes whose runs are complete.
    pub initial_shapes: u64,
    /// Shapes derived, leaves included.
    pub shapes: u64,
    /// Leaves handed to sinks.
    pub leaves: u64,
}

/// Follows the progress of runs and ends them early. Copies are the same watch.
///
/// Put it into [`Settings::watch`]. It works for a single run, for a session and for runs in parallel.
///
/// ```
/// use cga_runtime::run::settings::Settings;
/// use cga_runtime::run::watch::Watch;
///
/// let watch = Watch::new();
/// let settings = Settings { watch: Some(watch.clone()), ..Settings::default() };
/// // Runs with `settings` end as soon as another thread, or a sink, calls this:
/// watch.stop();
/// assert!(watch.is_stopped() && settings.watch.is_some_and(|watch| watch.is_stopped()));
/// ```
#[derive(Clone, Default)]
pub struct Watch {
    shared: Arc<Shared>,
}

type Callback = Box<dyn FnMut(Progress) -> Flow + Send>;

#[derive(Default)]
struct Shared {
    stopped: AtomicBool,
    initial_shapes: AtomicU64,
    shapes: AtomicU64,
    leaves: AtomicU64,
    callback: Option<(u64, Mutex<Callback>)>,
}

impl fmt::Debug for Watch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Watch").field("progress", &self.progress()).field("stopped", &self.is_stopped()).finish()
    }
}

impl Watch {
    /// A watch without a callback: ask it for its [`progress`](Watch::progress) whenever you like.
    pub fn new() -> Self {
        Watch::default()
    }

    /// A watch that calls back about each `shapes` shapes derived, on the thread of a run. `Break` ends all runs.
    ///
    /// A run asks every [`STRIDE`] shapes at most, so calls come in steps of that. There is never more than one call at a time;
    /// while one lasts, others are left out.
    ///
    /// ```
    ///     /// use cga_runtime::run::watch::Watch;
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
            shared: Arc::new(Shared { callback: Some((shapes.max(1), Mutex::new(callback))), ..Shared::default() }),
        }
    }

    /// Ends all runs with this watch, soon: each returns with `stopped` in its report. Later runs end before they begin.
    pub fn stop(&self) {
        self.shared.stopped.store(true, Ordering::Relaxed);
    }

    /// True if [`stop`](Watch::stop) was called or the callback returned `Break`.
    pub fn is_stopped(&self) -> bool {
        self.shared.stopped.load(Ordering::Relaxed)
    }

    /// How far the runs have come, as of their last questions.
    pub fn progress(&self) -> Progress {
        let read = |counter: &AtomicU64| counter.load(Ordering::Relaxed);
        Progress {
            initial_shapes: read(&self.shared.initial_shapes),
            shapes: read(&self.shared.shapes),
            leaves: read(&self.shared.leaves),
        }
    }

    /// Adds what a run has made since it last told.
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
            // Also when the callback itself runs a grammar.
            Err(TryLockError::WouldBlock) => return,
        };
        if callback(self.progress()).is_break() {
            self.stop();
        }
    }
}
