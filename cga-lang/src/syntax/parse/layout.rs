//! The structure that is known before parsing: pairs of brackets, and the starts of declarations.
//!
//! The body of a rule has no end symbol: it runs to the next declaration. `Name -->`, `attr name` and `@` always
//! begin a declaration, even inside brackets that were left open. `name =` does so only outside brackets, because it
//! is an arm in a comp block. No declaration begins between the parentheses of an import, where rules are replaced.

use super::brackets::{NONE, Open};
use super::head::{Head, Heads};
use crate::syntax::token::{Sym, Tok};
use std::collections::HashSet;

/// The significant tokens and their structure.
pub(super) struct Layout<'a> {
    heads: Heads<'a>,
    close: Vec<u32>,
    /// True for each position where a declaration begins.
    starts: Vec<bool>,
    /// For each position, the next position where a declaration begins.
    borders: Vec<u32>,
    /// The number of unreadable tokens before each position.
    bad: Vec<u32>,
    /// The names of rules.
    rules: HashSet<&'a str>,
    /// The names of all declarations.
    declared: HashSet<&'a str>,
}

impl<'a> Layout<'a> {
    /// `view` has the indices of the significant tokens.
    pub(super) fn new(tokens: &'a [Tok], view: Vec<u32>) -> Self {
        let mut bad = Vec::with_capacity(view.len());
        // Tokens before the first one belong to other files.
        let (mut count, mut next) = (0, view.first().map_or(tokens.len(), |&first| first as usize));
        for &index in &view {
            count += tokens[next..index as usize].iter().filter(|token| matches!(token, Tok::Bad)).count() as u32;
            next = index as usize;
            bad.push(count);
        }
        bad.push(count + tokens[next..].iter().filter(|token| matches!(token, Tok::Bad)).count() as u32);
        let heads = Heads::new(tokens, view);
        let length = heads.len();
        let mut layout = Layout {
            heads,
            close: vec![NONE; length],
            starts: vec![false; length],
            borders: vec![length as u32; length + 1],
            bad,
            rules: HashSet::new(),
            declared: HashSet::new(),
        };
        layout.find_starts();
        for position in (0..length).rev() {
            layout.borders[position] =
                if layout.starts[position] { position as u32 } else { layout.borders[position + 1] };
        }
        layout
    }

    fn find_starts(&mut self) {
        let mut open = Open::default();
        // The ends of a name with dots, and of the overrides of an import.
        let (mut name_end, mut quiet) = (0, 0);
        for position in 0..self.heads.len() {
            let Some(token) = self.heads.at(position) else { break };
            if let Some(name) = token.ident().filter(|_| quiet <= position && name_end <= position) {
                name_end = self.heads.name_end(position);
                let head = self.heads.head(position);
                if head.is_some_and(Head::is_sure) || self.heads.keyword(position) {
                    open = Open::default();
                    self.starts[position] = true;
                } else if head.is_some() && open.is_empty() && !self.heads.behind_type(position) {
                    self.starts[position] = true;
                }
                if self.starts[position] {
                    self.declared.insert(name);
                    self.declared.extend(self.heads.at(position + 1).and_then(Tok::ident));
                }
                if head.is_some_and(|head| head != Head::Function) && name_end == position + 1 {
                    self.rules.insert(name);
                }
            } else if token.is(Sym::At) && quiet <= position {
                open = Open::default();
                self.starts[position] = true;
            }
            if token.is(Sym::LParen) && self.heads.holds_overrides(position) {
                quiet = quiet.max(self.heads.pair(position).unwrap_or(0));
            }
            if let Tok::Sym(sym) = token {
                // An unclosed parenthesis or bracket hides no declarations. An unclosed brace does, because arms look
                // like functions.
                if !matches!(sym, Sym::LParen | Sym::LBracket) || self.heads.pair(position).is_some() {
                    open.pass(*sym, position, &mut self.close);
                }
            }
        }
    }

    /// The number of significant tokens.
    pub(super) fn len(&self) -> usize {
        self.heads.len()
    }

    /// The token at a position.
    pub(super) fn at(&self, position: usize) -> Option<&'a Tok> {
        self.heads.at(position)
    }

    /// The index of the token at a position.
    pub(super) fn index(&self, position: usize) -> Option<u32> {
        self.heads.index(position)
    }

    /// The continuation of a declaration of the name at `position`, if it is declared there.
    pub(super) fn head(&self, position: usize) -> Option<Head> {
        self.heads.head(position)
    }

    /// The continuation of a name at `position` between the parentheses of an import.
    pub(super) fn override_head(&self, position: usize) -> Option<Head> {
        self.heads.override_head(position)
    }

    /// Returns true if the name at `position` is an import.
    pub(super) fn is_import(&self, position: usize) -> bool {
        self.heads.is_import(position)
    }

    /// The position after the name at `position`: after `lib.Wall` if `lib` is an import.
    pub(super) fn name_end(&self, position: usize) -> usize {
        self.heads.name_end(position)
    }

    /// The position after words joined by dots.
    pub(super) fn path_end(&self, position: usize) -> usize {
        self.heads.path_end(position)
    }

    /// Returns true if the parentheses at `position` replace attributes and rules of an import.
    pub(super) fn holds_overrides(&self, position: usize) -> bool {
        self.heads.holds_overrides(position)
    }

    /// Returns true if a declaration begins at `position`, or if the text ends there.
    pub(super) fn is_border(&self, position: usize) -> bool {
        self.starts.get(position).copied().unwrap_or(true)
    }

    /// The first position at or after `position` where a declaration begins.
    pub(super) fn border(&self, position: usize) -> usize {
        self.borders.get(position).map_or(self.len(), |&border| border as usize)
    }

    /// Returns true if a rule with the name is declared.
    pub(super) fn has_rule(&self, name: &str) -> bool {
        self.rules.contains(name)
    }

    /// Returns true if the name is declared.
    pub(super) fn declares(&self, name: &str) -> bool {
        self.declared.contains(name)
    }

    /// The position of the bracket that closes the one at `position`.
    pub(super) fn close(&self, position: usize) -> Option<usize> {
        self.close.get(position).filter(|&&close| close != NONE).map(|&close| close as usize)
    }

    /// Returns true if an unreadable token is directly before or after the token at `position`.
    pub(super) fn beside_bad(&self, position: usize) -> bool {
        let bad = |position: usize| self.bad.get(position).or(self.bad.last()).copied().unwrap_or(0);
        let before = position.checked_sub(1).map_or(0, bad);
        before < bad(position + 1)
    }

    /// Returns true if an unreadable token is between `position` and the end of the declaration.
    pub(super) fn bad_until_border(&self, position: usize) -> bool {
        let border = self.border(position + 1);
        let bad = |position: usize| self.bad.get(position).or(self.bad.last()).copied().unwrap_or(0);
        bad(position) < bad(border)
    }
}
