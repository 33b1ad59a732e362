//! Finds text that is written twice.

use crate::span::Span;
use crate::syntax::token::Tok;
use std::collections::HashMap;
use std::hash::{BuildHasher, RandomState};

/// Parts of the rules with a value each, found by their tokens. The first part with the same tokens counts.
pub(crate) struct Written<'t, T> {
    tokens: &'t [Tok],
    hasher: RandomState,
    /// By the hash of the tokens.
    parts: HashMap<u64, Vec<(&'t [Tok], T)>>,
}

impl<'t, T> Written<'t, T> {
    /// An empty list. Spans count `tokens`.
    pub(crate) fn new(tokens: &'t [Tok]) -> Self {
        Written { tokens, hasher: RandomState::new(), parts: HashMap::new() }
    }

    fn part(&self, span: Span) -> &'t [Tok] {
        self.tokens.get(span.first as usize..=span.last as usize).unwrap_or_default()
    }

    /// Returns the value of the first part with the same tokens.
    pub(crate) fn find(&self, span: Span) -> Option<&T> {
        let part = self.part(span);
        let alike = self.parts.get(&self.hasher.hash_one(part))?;
        alike.iter().find(|(tokens, _)| *tokens == part).map(|(_, value)| value)
    }

    /// Adds a part, unless there is one with the same tokens.
    pub(crate) fn add(&mut self, span: Span, value: T) {
        let part = self.part(span);
        let alike = self.parts.entry(self.hasher.hash_one(part)).or_default();
        if !alike.iter().any(|(tokens, _)| *tokens == part) {
            alike.push((part, value));
        }
    }
}
