//! Sessions, many shapes at once, streaming, progress: the results are those of a loop over the shapes, to the byte.

mod errors;
mod grammars;
#[path = "../laws/host.rs"]
mod host;
mod nested;
mod play;
#[path = "../../cga-lang/tests/common/random.rs"]
mod random;
mod same;
mod session;
#[path = "../laws/start.rs"]
mod start;
mod streamed;
mod watched;
#[allow(deprecated, reason = "findings are warnings of this kind")]
#[path = "../laws/grammars.rs"]
mod written;

/// Runs it with that many threads; without the feature `rayon` always with one.
fn with_threads<T: Send>(threads: usize, run: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    pool.install(run)
}

/// Numbers of threads to try.
const THREADS: [usize; 3] = [1, 2, 7];
