//! Work on threads of its own, without the interpreter lock, that Ctrl-C ends.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread::Builder;
use std::time::Duration;

use cga::Watch;
use pyo3::prelude::*;

use crate::errors::{RunError, panicked};

/// The stack of a thread. Threads of Python differ between platforms, and runs nest deeply.
pub(crate) const STACK: usize = 16 << 20;

/// The time between two questions for Ctrl-C.
const PAUSE: Duration = Duration::from_millis(50);

/// Does the work on another thread, while this one waits for it without the interpreter lock. A signal such as Ctrl-C stops the watch, and its
/// exception is raised when the work has ended.
///
/// # Errors
/// The exception of a signal, and a `RunError` for a panic.
pub(crate) fn supervised<T: Send>(py: Python<'_>, watch: &Watch, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let (outcome, signal) = py.detach(|| {
        std::thread::scope(|scope| {
            let (ended, end) = channel::<()>();
            let caught = move || {
                // Dropped when the work ends, which wakes the other thread.
                let _ended = ended;
                catch_unwind(AssertUnwindSafe(work))
            };
            let thread = match Builder::new().name("cga".to_owned()).stack_size(STACK).spawn_scoped(scope, caught) {
                Ok(thread) => thread,
                Err(why) => return (Err(why), None),
            };
            let mut signal = None;
            while let Err(RecvTimeoutError::Timeout) = end.recv_timeout(PAUSE) {
                if signal.is_none() {
                    signal = Python::attach(|py| py.check_signals()).err();
                }
                if signal.is_some() {
                    watch.stop();
                }
            }
            (Ok(thread.join().and_then(|caught| caught)), signal)
        })
    });
    let outcome: Result<T, Box<dyn Any + Send>> =
        outcome.map_err(|why| RunError::new_err(format!("cannot start a thread: {why}")))?;
    match signal {
        Some(signal) => Err(signal),
        None => outcome.map_err(|_| panicked(py)),
    }
}

/// Does the work on this thread without the interpreter lock.
///
/// # Errors
/// A `RunError` for a panic.
pub(crate) fn guarded<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    py.detach(|| catch_unwind(AssertUnwindSafe(work)).map_err(|_| ())).map_err(|()| panicked(py))
}
