//! Where something stands in the source, as a handle.

/// A run of tokens by index, both ends included.
///
/// Only the door that brought the text in knows where token 7 is on screen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span {
    /// Index of the first token.
    pub first: u32,
    /// Index of the last token.
    pub last: u32,
}

impl Span {
    /// The span of one token.
    pub const fn one(token: u32) -> Self {
        Span { first: token, last: token }
    }

    /// The span as many tokens further on.
    pub(crate) fn behind(self, tokens: u32) -> Span {
        Span { first: self.first + tokens, last: self.last + tokens }
    }

    /// The smallest span that holds both.
    pub fn to(self, other: Span) -> Span {
        Span { first: self.first.min(other.first), last: self.last.max(other.last) }
    }
}
