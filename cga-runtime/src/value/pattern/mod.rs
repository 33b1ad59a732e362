//! Regular expressions for `splitString`, which takes them after a `$`, in Perl's notation.
//!
//! The crate has its own matcher because the reference's own example uses lookbehind (`(?<=a)b(?=a)`), which
//! linear-time matchers, `regex-lite` included, do not support. The matcher tries alternatives in order and remembers
//! the failed ones, so the time of every pattern is bounded. Back references are not supported.
//!
//! [`Regex::new`] parses (`parse.rs`) and compiles to steps (`program.rs`); [`RegexSearch`] runs them (`run.rs`).

mod parse;
mod program;
mod run;
mod set;

pub(crate) use program::Regex;
pub(crate) use run::{RegexSearch, TooLong};

#[cfg(test)]
mod tests;
