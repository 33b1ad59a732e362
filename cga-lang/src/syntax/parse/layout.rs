//! The structure that is known before parsing: pairs of brackets, and the starts of declarations.
//!
//! The body of a rule has no end symbol: it runs to the next declaration. `Name -->`, `attr name` and `@` always
//! begin a declaration, even inside brackets that were left open. `name =` does so only outside brackets, because it
//! is an arm in a comp block. No declaration begins between the parentheses of an import, where rules are replaced.

use super::brackets::{OpenBrackets, pairs};
use crate::syntax::token::{Sym, Tok};
use std::collections::HashSet;

/// The continuation of a declaration after its name, parameters and `with`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Head {
    /// `-->`.
    Rule,
    /// `. -->`, as in old files.
    Leaf,
    /// `=`.
    Function,
    /// A misspelled `-->`, with the number of its tokens.
    Slip(usize),
}

impl Head {
    /// Returns true if only a declaration continues like this.
    pub(super) fn is_sure(self) -> bool {
        matches!(self, Head::Rule | Head::Leaf)
    }
}

/// The significant tokens and their structure. Positions count the significant tokens.
#[derive(Default)]
pub(super) struct Layout<'a> {
    tokens: &'a [Tok],
    /// The indices of the significant tokens.
    view: Vec<u32>,
    /// The closing bracket of each bracket, regardless of declarations.
    pairs: Vec<Option<usize>>,
    /// The closing bracket of each bracket, between two declarations.
    close: Vec<Option<usize>>,
    /// For each position, the next position where a declaration begins.
    borders: Vec<usize>,
    /// The number of unreadable tokens before each position.
    bad: Vec<u32>,
    /// The names of imports.
    pub(super) imports: HashSet<&'a str>,
    /// Names of rules that are declared with a dot.
    pub(super) dotted: HashSet<(&'a str, &'a str)>,
    /// The positions of parentheses after the path of an import.
    pub(super) overrides: HashSet<usize>,
    /// The names of rules.
    rules: HashSet<&'a str>,
    /// The names of all declarations.
    declared: HashSet<&'a str>,
}

impl<'a> Layout<'a> {
    /// `view` has the indices of the significant tokens, `bad` the number of unreadable tokens before each of them.
    pub(super) fn new(tokens: &'a [Tok], view: Vec<u32>, bad: Vec<u32>) -> Self {
        let length = view.len();
        let pairs = pairs(view.iter().map(|&index| &tokens[index as usize]), length);
        let (close, borders) = (vec![None; length], vec![length; length + 1]);
        let mut layout = Layout { tokens, view, pairs, close, borders, bad, ..Layout::default() };
        layout.find_imports();
        layout.find_starts();
        for position in (0..length).rev() {
            layout.borders[position] = layout.borders[position].min(layout.borders[position + 1]);
        }
        layout
    }

    fn find_starts(&mut self) {
        let mut open = OpenBrackets::default();
        // The ends of a name with dots, and of the overrides of an import.
        let (mut name_end, mut quiet) = (0, 0);
        for position in 0..self.len() {
            let Some(token) = self.at(position) else { break };
            if let Some(name) = token.ident().filter(|_| quiet <= position && name_end <= position) {
                name_end = self.name_end(position);
                let head = self.head(position);
                if head.is_some_and(Head::is_sure) || self.keyword(position) {
                    open = OpenBrackets::default();
                    self.borders[position] = position;
                } else if head.is_some() && open.is_empty() && !self.behind_type(position) {
                    self.borders[position] = position;
                }
                if self.borders[position] == position {
                    self.declared.insert(name);
                    self.declared.extend(self.at(position + 1).and_then(Tok::ident));
                }
                if head.is_some_and(|head| head != Head::Function) && name_end == position + 1 {
                    self.rules.insert(name);
                }
            } else if token.is(Sym::At) && quiet <= position {
                open = OpenBrackets::default();
                self.borders[position] = position;
            }
            if token.is(Sym::LParen) && self.holds_overrides(position) {
                quiet = quiet.max(self.pair(position).unwrap_or(0));
            }
            if let Tok::Sym(sym) = token {
                // An unclosed parenthesis or bracket hides no declarations. An unclosed brace does, because arms look
                // like functions.
                if !matches!(sym, Sym::LParen | Sym::LBracket) || self.pair(position).is_some() {
                    open.pass(*sym, position, &mut self.close);
                }
            }
        }
    }

    /// The number of significant tokens.
    pub(super) fn len(&self) -> usize {
        self.view.len()
    }

    /// The index of the token at a position.
    pub(super) fn index(&self, position: usize) -> Option<u32> {
        self.view.get(position).copied()
    }

    /// The token at a position.
    pub(super) fn at(&self, position: usize) -> Option<&'a Tok> {
        self.index(position).map(|index| &self.tokens[index as usize])
    }

    /// Returns true if the token at a position is the symbol.
    pub(super) fn is(&self, position: usize, sym: Sym) -> bool {
        self.at(position).is_some_and(|token| token.is(sym))
    }

    /// The name or keyword at a position.
    pub(super) fn word(&self, position: usize) -> Option<&'a str> {
        self.at(position).and_then(Tok::ident)
    }

    /// The bracket that closes the one at `position`, regardless of declarations.
    pub(super) fn pair(&self, position: usize) -> Option<usize> {
        self.pairs.get(position).copied().flatten()
    }

    /// Returns true if a declaration begins at `position`, or if the text ends there.
    pub(super) fn is_border(&self, position: usize) -> bool {
        self.border(position) <= position
    }

    /// The first position at or after `position` where a declaration begins.
    pub(super) fn border(&self, position: usize) -> usize {
        self.borders.get(position).copied().unwrap_or(self.len())
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
        self.close.get(position).copied().flatten()
    }

    /// Returns true if an unreadable token is directly before or after the token at `position`.
    pub(super) fn beside_bad(&self, position: usize) -> bool {
        position.checked_sub(1).map_or(0, |before| self.bad_before(before)) < self.bad_before(position + 1)
    }

    /// Returns true if an unreadable token is between `position` and the end of the declaration.
    pub(super) fn bad_until_border(&self, position: usize) -> bool {
        self.bad_before(position) < self.bad_before(self.border(position + 1))
    }

    fn bad_before(&self, position: usize) -> u32 {
        self.bad.get(position).or(self.bad.last()).copied().unwrap_or(0)
    }
}
