//! Heads of declarations, and names with dots.
//!
//! Tokens alone do not tell `lib.Wall` from a leaf `lib.` and a call of `Wall`. In a rule, a dot joins names if the
//! first name is an import of this grammar, or if a rule with the joined name is declared.

use super::layout::{Head, Layout};
use super::type_words::is_type;
use crate::ops;
use crate::syntax::token::{Sym, Tok};

/// The limit for searches without a known end; it keeps the parser linear.
const LONGEST_HEAD: usize = 100;

impl<'a> Layout<'a> {
    /// Finds the imports and the rules with dotted names.
    pub(super) fn find_imports(&mut self) {
        for position in 0..self.len() {
            if self.at(position + 1) == Some(&Tok::Joint)
                && self.head_behind(position, position + 3) == Some(Head::Rule)
            {
                self.dotted.extend(self.word(position).zip(self.word(position + 2)));
            }
            if self.word(position) == Some("import") {
                self.import(position);
            }
        }
    }

    /// `import id (styles) : "path" (overrides)`.
    fn import(&mut self, position: usize) {
        if let Some(Tok::Str(path)) = self.at(position + 1) {
            // Without a prefix, the name of the file was meant as the prefix.
            self.imports.insert(stem(path));
        }
        let Some(id) = self.word(position + 1) else { return };
        let mut next = position + 2;
        if self.is(next, Sym::LParen) {
            next = self.pair(next).map_or(next, |close| close + 1);
        }
        // Without the colon, the prefix still tells the meaning of the dots after it.
        self.imports.insert(id);
        if !self.is(next, Sym::Colon) {
            return;
        }
        if matches!(self.at(next + 1), Some(Tok::Str(_))) && self.is(next + 2, Sym::LParen) {
            self.overrides.insert(next + 2);
        }
    }

    /// Returns true if the name at `position` is an import.
    pub(super) fn is_import(&self, position: usize) -> bool {
        self.word(position).is_some_and(|name| self.imports.contains(name))
    }

    /// The position after a name that may have dots.
    pub(super) fn name_end(&self, position: usize) -> usize {
        if self.is_import(position) { self.path_end(position) } else { self.dotted_end(position) }
    }

    /// The position after a name at `position` that is not an import. The name includes dots if such a rule is
    /// declared.
    fn dotted_end(&self, position: usize) -> usize {
        let end = self.joined_end(position, |end| self.at(end) == Some(&Tok::Joint));
        if position + 1 < end && self.head_behind(position, end) == Some(Head::Rule) {
            return end;
        }
        let parts = self.word(position).zip(self.word(position + 2)).filter(|_| self.is(position + 1, Sym::Dot));
        let is_declared = parts.is_some_and(|parts| self.dotted.contains(&parts));
        // Otherwise it is a leaf before the declaration of another rule.
        let is_call = || !self.is_head(position + 2, position + 3);
        if is_declared && is_call() { position + 3 } else { position + 1 }
    }

    /// Returns true if a name from `position` to `end` is certainly declared there.
    fn is_head(&self, position: usize, end: usize) -> bool {
        self.head_behind(position, end).is_some_and(Head::is_sure)
    }

    /// The position after words joined by dots.
    pub(super) fn path_end(&self, position: usize) -> usize {
        self.joined_end(position, |end| self.is(end, Sym::Dot))
    }

    /// The position after words between which `joins` holds.
    fn joined_end(&self, position: usize, joins: impl Fn(usize) -> bool) -> usize {
        let mut end = position + 1;
        while end < position + LONGEST_HEAD && joins(end) && self.word(end + 1).is_some() {
            end += 2;
        }
        end
    }

    /// Returns true if the parentheses at `position` replace attributes and rules of an import.
    pub(super) fn holds_overrides(&self, position: usize) -> bool {
        if self.overrides.contains(&position) {
            return true;
        }
        let Some(close) = self.pair(position) else { return false };
        if position == 0 || self.word(position - 1).is_none() {
            return false;
        }
        if !self.is(close + 1, Sym::Dot) || self.word(close + 2).is_none() {
            return false;
        }
        // A missing import leaves enough evidence.
        self.is_import(position - 1)
            || (self.word(position + 1).is_some() && self.is(self.path_end(position + 1), Sym::Assign))
            || self.override_head(position + 1) == Some(Head::Rule)
    }

    /// Returns true if a word at `position` begins a declaration, together with the tokens that it requires.
    pub(super) fn keyword(&self, position: usize) -> bool {
        let name = self.word(position + 1).is_some();
        match self.word(position) {
            Some("attr" | "const") => name,
            Some("import") => name || matches!(self.at(position + 1), Some(Tok::Str(_))),
            Some("version") => matches!(self.at(position + 1), Some(Tok::Str(_))),
            Some("style") => name && self.head(position + 1).is_none(),
            Some("start" | "extension") => name && self.head(position + 1).is_some_and(Head::is_sure),
            _ => false,
        }
    }

    /// Returns true if the name at `position` belongs to an attribute or constant and has a type before it, or if it
    /// is the type after such a name.
    pub(super) fn behind_type(&self, position: usize) -> bool {
        let word = |back: usize| position.checked_sub(back).and_then(|position| self.word(position));
        let declares = |back: usize| matches!(word(back), Some("attr" | "const"));
        (word(1).is_some_and(is_type) && declares(2))
            || (self.word(position).is_some_and(is_type)
                && position.checked_sub(1).is_some_and(|before| self.is(before, Sym::Colon))
                && word(2).is_some()
                && declares(3))
    }

    /// The continuation of a declaration of the name at `position`, if it is declared there.
    pub(super) fn head(&self, position: usize) -> Option<Head> {
        // `case h = 3 :` means `==`, and the parser reports it.
        self.head_behind(position, self.name_end(position))
            .filter(|head| if head.is_sure() { !self.is_selector(position) } else { !self.in_value(position) })
    }

    /// Returns true if the name of a selector begins an arm at `position`, whatever separates it from its operations.
    fn is_selector(&self, position: usize) -> bool {
        let begins = |before| self.is(before, Sym::LBrace) || self.is(before, Sym::Bar);
        position.checked_sub(1).is_some_and(begins)
            && self.word(position).is_some_and(|word| ops::selector(word).is_some())
    }

    /// The continuation of a name at `position` between the parentheses of an import.
    pub(super) fn override_head(&self, position: usize) -> Option<Head> {
        self.head_behind(position, self.path_end(position))
    }

    /// The continuation after a name from `position` to `end`.
    fn head_behind(&self, position: usize, end: usize) -> Option<Head> {
        if self.word(position)? == "with" {
            return None;
        }
        let mut next = end;
        let mut names = true;
        if self.is(next, Sym::LParen) {
            next += 1;
            // The search ends at the next parenthesis of either kind, so that no token is visited twice.
            while !self.is(next, Sym::RParen) {
                let token = self.at(next).filter(|token| !token.is(Sym::LParen))?;
                names &= token.is(Sym::Comma) || token.ident().is_some();
                next += 1;
            }
            next += 1;
        }
        if self.word(next) == Some("with") && self.is(next + 1, Sym::LParen) {
            match self.pair(next + 1) {
                Some(close) => next = close + 1,
                None => return self.arrow_near(next + 1).then_some(Head::Rule),
            }
        }
        if self.is(next, Sym::Arrow) {
            return Some(Head::Rule);
        }
        if self.is(next, Sym::Dot) && self.is(next + 1, Sym::Arrow) {
            return Some(Head::Leaf);
        }
        if !names {
            return None;
        }
        let slips: [&[Sym]; 5] = [
            &[Sym::Minus, Sym::Arrow],
            &[Sym::Minus, Sym::Greater],
            &[Sym::Minus, Sym::Minus, Sym::Greater],
            &[Sym::Assign, Sym::Greater],
            &[Sym::EqEq, Sym::Greater],
        ];
        let slip = slips.iter().find(|slip| slip.iter().enumerate().all(|(ahead, &sym)| self.is(next + ahead, sym)));
        match slip {
            Some(slip) => Some(Head::Slip(slip.len())),
            None => self.is(next, Sym::Assign).then_some(Head::Function),
        }
    }

    fn arrow_near(&self, position: usize) -> bool {
        (position..position + LONGEST_HEAD).any(|next| self.is(next, Sym::Arrow))
    }

    /// Returns true if the token before the name requires a value.
    fn in_value(&self, mut position: usize) -> bool {
        // Go back to the first part of a name with dots.
        for _ in 0..LONGEST_HEAD {
            if position < 2 || !self.is(position - 1, Sym::Dot) || self.word(position - 2).is_none() {
                break;
            }
            position -= 2;
        }
        match position.checked_sub(1).and_then(|before| self.at(before)) {
            Some(Tok::Ident(word)) => word == "case",
            Some(Tok::Sym(sym)) => match sym {
                Sym::LParen | Sym::LBracket | Sym::Comma => true,
                Sym::AndAnd | Sym::OrOr | Sym::Bang | Sym::EqEq | Sym::NotEq => true,
                sym if sym.is_operator() => self.in_condition(position),
                _ => false,
            },
            _ => false,
        }
    }

    /// Returns true if a `case` precedes `position`, with only parts of a value in between.
    fn in_condition(&self, position: usize) -> bool {
        let parts = |token: &&Tok| match token {
            Tok::Ident(_) | Tok::Number(_) | Tok::Str(_) | Tok::Host(_) | Tok::Path(_) | Tok::Joint => true,
            Tok::Sym(sym) => {
                sym.is_operator()
                    || matches!(sym, Sym::LParen | Sym::RParen | Sym::LBracket | Sym::RBracket | Sym::Comma | Sym::Dot)
            }
            _ => false,
        };
        let before = (position.saturating_sub(LONGEST_HEAD)..position).rev().filter_map(|before| self.at(before));
        before.take_while(parts).any(|token| token.ident() == Some("case"))
    }
}

/// The name of a file without its folder and ending.
pub(super) fn stem(path: &str) -> &str {
    let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
    name.split_once('.').map_or(name, |(stem, _)| stem)
}
