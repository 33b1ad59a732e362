//! The parser. It never fails, never panics and always ends.
//!
//! A function that meets a mistake reports it and returns `Err(Reported)`, which is not reported again. Parsing
//! continues after the nearest slot or arm, otherwise after the declaration, so a mistake in one rule does not hide
//! mistakes in another.

mod annotation;
mod arms;
mod array;
mod block;
mod brackets;
mod branch;
mod expr;
mod head;
mod import;
mod item;
mod layout;
mod op;
mod recovery;
mod report;
mod slots;
mod style;
mod type_words;
mod with;

use crate::diag::code::Code;
use crate::diag::{Diag, Diags};
use crate::span::Span;
use crate::syntax::ast::{Ast, Name};
use crate::syntax::token::{Sym, Tok, Tokens};
use layout::Layout;
use report::LIST;
use std::collections::HashMap;
use std::ops::Range;

/// The maximum depth of brackets and branches, and of an expression.
pub const MAX_DEPTH: u32 = 200;

/// Builds the tree and reports mistakes to `diags`.
pub fn parse(tokens: &Tokens, diags: &mut Diags) -> Ast {
    parse_part(tokens, 0..tokens.len() as u32, diags)
}

/// Builds the tree of a part of the tokens. Spans count all tokens.
pub(crate) fn parse_part(tokens: &Tokens, part: Range<u32>, diags: &mut Diags) -> Ast {
    let mut parser = Parser::new(&tokens.as_slice()[..part.end as usize], part.start);
    let ast = parser.grammar();
    diags.append(parser.diags.finish());
    parser.muted.finish();
    ast
}

/// The mark of a mistake that has been reported.
struct Reported;

impl From<&mut Diag> for Reported {
    fn from(_: &mut Diag) -> Reported {
        Reported
    }
}

type Parsed<T> = Result<T, Reported>;

struct Parser<'a> {
    /// The significant tokens. Positions count these; spans count all tokens.
    layout: Layout<'a>,
    /// Doc comments, by the position after them.
    docs: Vec<(usize, &'a str)>,
    at: usize,
    depth: u32,
    /// True if `TooDeep` was reported in this declaration.
    deep: bool,
    /// True if a `{` was missing in this declaration. Its `}` is then left over.
    lacks_brace: bool,
    /// True while a size or an argument is parsed that can be relative.
    relative: bool,
    /// True if a comma ends the operations of a rule, as between overrides.
    comma_ends: bool,
    /// The remaining loop steps. The limit guards against a loop without progress.
    fuel: usize,
    /// The numbers of styles by name.
    styles: HashMap<String, u32>,
    lost: Vec<String>,
    diags: Diags,
    /// Diagnostics about places where the source has already reported unreadable text.
    muted: Diags,
}

impl<'a> Parser<'a> {
    fn new(tokens: &'a [Tok], first: u32) -> Self {
        let (mut view, mut docs, mut bad) = (Vec::with_capacity(tokens.len()), Vec::new(), Vec::new());
        // The number of unreadable tokens after the first significant one.
        let mut count = 0;
        for (index, token) in tokens.iter().enumerate().skip(first as usize) {
            match token {
                Tok::Bad => count += u32::from(!view.is_empty()),
                Tok::Doc(text) => docs.push((view.len(), text.as_str())),
                _ => {
                    view.push(index as u32);
                    bad.push(count);
                }
            }
        }
        bad.push(count);
        Parser {
            layout: Layout::new(tokens, view, bad),
            docs,
            at: 0,
            depth: 0,
            deep: false,
            lacks_brace: false,
            relative: false,
            comma_ends: false,
            fuel: tokens.len() * 32 + 1000,
            styles: HashMap::new(),
            lost: Vec::new(),
            diags: Diags::new(),
            muted: Diags::new(),
        }
    }

    /// The token at a distance of `ahead` from the current one.
    fn nth(&self, ahead: usize) -> Option<&'a Tok> {
        self.layout.at(self.at + ahead)
    }

    fn peek(&self) -> Option<&'a Tok> {
        self.nth(0)
    }

    /// The token at a distance of `back` before the current one.
    fn before(&self, back: usize) -> Option<&'a Tok> {
        self.layout.at(self.at.checked_sub(back)?)
    }

    fn is(&self, sym: Sym) -> bool {
        self.nth_is(0, sym)
    }

    fn nth_is(&self, ahead: usize, sym: Sym) -> bool {
        self.nth(ahead).is_some_and(|token| token.is(sym))
    }

    fn is_word(&self, word: &str) -> bool {
        self.peek().and_then(Tok::ident) == Some(word)
    }

    fn nth_is_name(&self, ahead: usize) -> bool {
        self.nth(ahead).is_some_and(|token| token.ident().is_some())
    }

    fn bump(&mut self) {
        self.at = (self.at + 1).min(self.layout.len());
    }

    /// Passes over a symbol if it is the current token.
    fn eat(&mut self, sym: Sym) -> bool {
        let found = self.is(sym);
        if found {
            self.bump();
        }
        found
    }

    /// Returns true if the declaration ends here.
    fn at_border(&self) -> bool {
        self.layout.is_border(self.at)
    }

    /// Counts a step of a loop. Returns false after the last step, and skips all remaining tokens.
    fn tick(&mut self) -> bool {
        if self.fuel == 1 {
            let span = self.span();
            self.diags.report(Code::TooDeep, span, "this cannot be read in reasonable time");
            self.at = self.layout.len();
        }
        self.fuel = self.fuel.saturating_sub(1);
        0 < self.fuel
    }

    /// The span of the token at a position, or of the last token.
    fn span_at(&self, at: usize) -> Span {
        match self.layout.index(at).or_else(|| self.layout.index(self.layout.len().checked_sub(1)?)) {
            Some(index) => Span::one(index),
            None => Span::default(),
        }
    }

    fn span(&self) -> Span {
        self.span_at(self.at)
    }

    /// The span from a position to the last token that was passed.
    fn span_from(&self, start: usize) -> Span {
        self.span_at(start).to(self.span_at(self.at.saturating_sub(1).max(start)))
    }

    /// Takes the current token as a name.
    fn take_name(&mut self) -> Option<Name> {
        let text = match self.peek()? {
            Tok::Ident(text) | Tok::Path(text) => text.clone(),
            _ => return None,
        };
        let span = self.span();
        self.bump();
        Some(Name { text, span })
    }

    /// Takes the tokens up to `end` as a name with dots.
    fn take_dotted(&mut self, end: usize) -> Option<Name> {
        let start = self.at;
        let mut name = self.take_name()?;
        while self.at < end && self.is(Sym::Dot) && self.tick() {
            let Some(part) = self.nth(1).and_then(Tok::ident) else { break };
            name.text.push('.');
            name.text.push_str(part);
            self.at += 2;
        }
        name.span = self.span_from(start);
        Some(name)
    }

    /// The position of the bracket that closes the current one. Reports a missing bracket.
    fn closing(&mut self) -> Parsed<usize> {
        if let Some(close) = self.layout.close(self.at) {
            return Ok(close);
        }
        let (span, open) = (self.span(), self.peek().map_or("bracket".into(), Tok::describe));
        let close = match self.peek() {
            Some(Tok::Sym(Sym::LParen)) => ")",
            Some(Tok::Sym(Sym::LBracket)) => "]",
            _ => "}",
        };
        // The bracket may be part of the unreadable text.
        let list = if self.layout.bad_until_border(self.at) { &mut self.muted } else { &mut self.diags };
        let diag = list.report(Code::UnclosedBracket, span, format!("this {open} is never closed"));
        Err(diag.help(format!("write `{close}` where it should end")).into())
    }

    /// Parses a part that may contain itself.
    fn nested<T>(&mut self, part: impl FnOnce(&mut Self) -> Parsed<T>) -> Parsed<T> {
        if MAX_DEPTH <= self.depth {
            return self.too_deep();
        }
        self.depth += 1;
        let result = part(self);
        self.depth -= 1;
        result
    }

    /// Parses a part in brackets, where a comma has no meaning for the outer part.
    fn bracketed<T>(&mut self, comma_ends: bool, part: impl FnOnce(&mut Self) -> Parsed<T>) -> Parsed<T> {
        let outside = std::mem::replace(&mut self.comma_ends, comma_ends);
        let result = self.nested(part);
        self.comma_ends = outside;
        result
    }

    /// Parses a part and returns its diagnostics, so that the caller can replace them.
    fn tried<T>(&mut self, part: impl FnOnce(&mut Self) -> T) -> (T, Vec<Diag>) {
        let before = std::mem::take(&mut self.diags);
        let result = part(self);
        let found = std::mem::replace(&mut self.diags, before).finish();
        (result, found)
    }

    /// Parses the parentheses here with one call of `item` for each part between commas, and passes over the closing
    /// one.
    fn between_commas<T>(&mut self, mut item: impl FnMut(&mut Self) -> Parsed<T>) -> Parsed<Vec<T>> {
        let close = self.closing()?;
        self.bump();
        let mut items = Vec::new();
        while self.at < close && self.tick() {
            items.push(item(self)?);
            if self.at < close && !self.eat(Sym::Comma) {
                return self.fail(LIST);
            }
        }
        self.at = close + 1;
        Ok(items)
    }

    /// Parses the braces here with one call of `item` for each part between `|`, and passes over the closing brace.
    /// Parts that fail are left out. If `form` is given, every part is required and has this form.
    fn between_bars<T>(&mut self, form: Option<&str>, mut item: impl FnMut(&mut Self) -> Parsed<T>) -> Parsed<Vec<T>> {
        let close = self.closing()?;
        self.bump();
        let mut items = Vec::new();
        while self.tick() {
            if let Some(form) = form.filter(|_| self.at == close || self.is(Sym::Bar)) {
                self.missing_part(form, close);
            } else if let Ok(one) = self.bracketed(false, &mut item) {
                items.push(one);
                if self.at < close && self.is(Sym::Comma) {
                    self.syntax(self.at, "parts are separated by `|`").help("write `|` for `,`");
                    self.bump();
                    continue;
                }
                if self.at < close && !self.is(Sym::Bar) {
                    self.expected("`|` or `}`");
                }
            }
            self.skip_to_bar(close);
            if close <= self.at {
                break;
            }
            self.bump();
        }
        self.at = close + 1;
        Ok(items)
    }

    /// Reports an empty part before a `|` or the end of the braces.
    fn missing_part(&mut self, form: &str, close: usize) {
        let before = self.at - 1;
        if self.at == close && self.layout.at(before).is_some_and(|token| token.is(Sym::LBrace)) {
            let span = self.span_at(before).to(self.span());
            let list = if self.layout.beside_bad(close) { &mut self.muted } else { &mut self.diags };
            let diag = list.report(Code::EmptyGroup, span, "these braces are empty");
            diag.help(format!("write `{form}` in them"));
            return;
        }
        let (at, side) = if self.at == close { (before, "after") } else { (self.at, "before") };
        let diag = self.syntax(at, format!("there is nothing {side} this `|`"));
        diag.help(format!("leave out the `|`, or write `{form}` {side} it"));
    }

    /// Skips to the end of the part between `|`.
    fn skip_to_bar(&mut self, close: usize) {
        while self.at < close && !self.is(Sym::Bar) {
            self.at = self.layout.close(self.at).unwrap_or(self.at) + 1;
        }
    }
}
