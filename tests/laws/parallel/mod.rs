//! Sessions, many shapes at once, streaming, progress: the results equal the results of a loop over the shapes, to the byte.

mod errors;
mod grammars;
mod nested;
mod play;
mod same;
mod session;
mod streamed;
mod watched;

/// Numbers of threads to try.
const THREADS: [usize; 3] = [1, 2, 7];
