//! Regular expressions, as `splitString` takes them behind a `$`: Perl's notation.
//!
//! An own matcher, because the reference's own example looks behind (`(?<=a)b(?=a)`), which the matchers that promise to
//! end leave out. (`regex-lite`, which is small, leaves it out too.) It tries alternatives in order and remembers where nothing came of it, so that no pattern takes more
//! than a bounded time. There are no references back to groups.
//!
//! [`Pattern::new`] reads (`parse.rs`) and makes steps of what it read (`program.rs`); [`Search`] runs them (`run.rs`).

mod parse;
mod program;
mod run;
mod set;
mod whole;

pub(crate) use program::Pattern;
pub(crate) use run::{Search, TooLong};
pub(crate) use whole::Whole;

#[cfg(test)]
mod tests;
