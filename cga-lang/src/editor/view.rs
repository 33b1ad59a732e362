//! The tokens of a file without comments and unreadable text.

use crate::syntax::token::{Sym, Tok};

fn is_significant(token: &Tok) -> bool {
    !matches!(token, Tok::Doc(_) | Tok::Bad)
}

/// The significant tokens.
pub(super) struct View<'a> {
    pub(super) tokens: &'a [Tok],
    /// Their indices.
    pub(super) list: Vec<u32>,
    /// The position after the bracket that closes a parenthesis.
    close: Vec<Option<usize>>,
}

impl<'a> View<'a> {
    pub(super) fn new(tokens: &'a [Tok]) -> Self {
        let list = (0..).zip(tokens).filter(|(_, token)| is_significant(token)).map(|(index, _)| index);
        let list: Vec<u32> = list.collect();
        View { tokens, close: closing(tokens, &list), list }
    }

    /// Returns true if white space may be between a name and the dot before it.
    pub(super) fn is_apart(&self, position: usize) -> bool {
        position.checked_sub(1).and_then(|dot| self.at(dot)) != Some(&Tok::Joint)
    }

    pub(super) fn at(&self, position: usize) -> Option<&'a Tok> {
        self.list.get(position).map(|index| &self.tokens[*index as usize])
    }

    pub(super) fn is(&self, position: usize, sym: Sym) -> bool {
        self.at(position).is_some_and(|token| token.is(sym))
    }

    pub(super) fn ident(&self, position: usize) -> Option<&'a str> {
        self.at(position).and_then(Tok::ident)
    }

    /// The position after a group in parentheses, or `position` without one.
    pub(super) fn after_group(&self, position: usize) -> usize {
        self.close.get(position).copied().flatten().unwrap_or(position)
    }
}

/// For each opening parenthesis the position after its closing one.
fn closing(tokens: &[Tok], view: &[u32]) -> Vec<Option<usize>> {
    let (mut close, mut open) = (vec![None; view.len()], Vec::new());
    for (position, index) in view.iter().enumerate() {
        let token = &tokens[*index as usize];
        if token.is(Sym::LParen) {
            open.push(position);
        } else if token.is(Sym::RParen)
            && let Some(from) = open.pop()
        {
            close[from] = Some(position + 1);
        }
    }
    close
}
