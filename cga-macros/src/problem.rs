//! An error that leaves no rules to compile.

use proc_macro2::Span;

/// A source that cannot be opened.
pub(crate) struct Problem {
    pub(crate) first: Span,
    pub(crate) last: Span,
    pub(crate) message: String,
}

impl Problem {
    pub(crate) fn new(first: Span, last: Span, message: impl Into<String>) -> Self {
        Problem { first, last, message: message.into() }
    }
}
