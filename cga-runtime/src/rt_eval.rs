//! The names that `cga-eval` uses besides the names in [`rt`](crate::rt). They are not part of the public promise either.

pub use crate::comp::Candidate;
pub use crate::run::rules::StartEntry;
