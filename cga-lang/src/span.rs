//! Places in the source, as handles.

/// A run of tokens by index, both ends included.
///
/// Only the source that delivered the tokens knows the place of a token in a file.
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

    /// The span moved by `tokens` tokens.
    pub(crate) fn behind(self, tokens: u32) -> Span {
        Span { first: self.first + tokens, last: self.last + tokens }
    }

    /// Returns true if all its tokens are in `other`.
    pub(crate) fn is_in(self, other: Span) -> bool {
        other.first <= self.first && self.last <= other.last
    }

    /// The smallest span that contains both.
    pub fn to(self, other: Span) -> Span {
        Span { first: self.first.min(other.first), last: self.last.max(other.last) }
    }
}
