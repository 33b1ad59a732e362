//! The threads that make tiles.

use std::sync::OnceLock;

use rayon::{ThreadPool, ThreadPoolBuilder};

static THREADS: OnceLock<Result<ThreadPool, String>> = OnceLock::new();

/// The threads that make tiles in this process; the first call sets their number, and 0 is one on each processor.
///
/// # Errors
/// A sentence: the threads cannot be started.
pub fn threads(count: usize) -> Result<&'static ThreadPool, String> {
    // Rules may be nested deeply.
    let start = || ThreadPoolBuilder::new().num_threads(count).stack_size(16 << 20).build();
    let threads = THREADS.get_or_init(|| start().map_err(|why| format!("cannot start threads: {why}")));
    threads.as_ref().map_err(String::clone)
}
