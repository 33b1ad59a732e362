//! An error that leaves no rules to compile.

use proc_macro2::Span;

/// A source that cannot be opened.
#[derive(Clone, Debug)]
pub struct Problem {
    /// The place where it begins.
    pub first: Span,
    /// The place where it ends.
    pub last: Span,
    /// The message, with lines that begin with `help: `.
    pub message: String,
}

impl Problem {
    /// A problem in a place.
    pub fn new(first: Span, last: Span, message: impl Into<String>) -> Self {
        Problem { first, last, message: message.into() }
    }
}
