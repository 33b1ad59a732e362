//! Tokens to tree. Never fails, never panics, always ends.
//!
//! A function that met something wrong reports it and returns `Err(Reported)`; nobody reports it again. The nearest
//! slot or arm, else the declaration, goes on behind it: a mistake in one rule does not hide those of another.

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
mod report;
mod slips;
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
use std::collections::HashMap;
use std::ops::Range;

/// Deepest nesting of brackets and branches, and deepest expression.
pub const MAX_DEPTH: u32 = 200;

/// Builds the tree; what is wrong goes to `diags`.
pub fn parse(tokens: &Tokens, diags: &mut Diags) -> Ast {
    parse_part(tokens, 0..tokens.len() as u32, diags)
}

/// Builds the tree of some of the tokens. Spans count all of them.
pub(crate) fn parse_part(tokens: &Tokens, part: Range<u32>, diags: &mut Diags) -> Ast {
    let mut parser = Parser::new(&tokens.as_slice()[..part.end as usize], part.start);
    let ast = parser.grammar();
    diags.append(parser.diags.finish());
    parser.muted.finish();
    ast
}

/// Something was wrong and has been reported.
struct Reported;

type Parsed<T> = Result<T, Reported>;

struct Parser<'a> {
    /// The tokens that count. Positions count these; spans count all.
    layout: Layout<'a>,
    /// Doc comments, by the position they stand before.
    docs: Vec<(usize, &'a str)>,
    at: usize,
    depth: u32,
    /// Whether `TooDeep` was reported in this declaration.
    deep: bool,
    /// Whether a comma ends the steps of a rule, as between what an import replaces.
    comma_ends: bool,
    /// Steps left before the parser gives up: a guard against a loop that makes no progress.
    fuel: usize,
    /// Numbers of styles by name.
    styles: HashMap<String, u32>,
    lost: Vec<String>,
    diags: Diags,
    /// What need not be said because the door has complained about the same place.
    muted: Diags,
}

impl<'a> Parser<'a> {
    fn new(tokens: &'a [Tok], first: u32) -> Self {
        let mut view = Vec::with_capacity(tokens.len());
        let mut docs = Vec::new();
        for (index, token) in tokens.iter().enumerate().skip(first as usize) {
            match token {
                Tok::Bad => {}
                Tok::Doc(text) => docs.push((view.len(), text.as_str())),
                _ => view.push(index as u32),
            }
        }
        Parser {
            layout: Layout::new(tokens, view),
            docs,
            at: 0,
            depth: 0,
            deep: false,
            comma_ends: false,
            fuel: tokens.len() * 32 + 1000,
            styles: HashMap::new(),
            lost: Vec::new(),
            diags: Diags::new(),
            muted: Diags::new(),
        }
    }

    /// The token `ahead` of the next one.
    fn nth(&self, ahead: usize) -> Option<&'a Tok> {
        self.layout.at(self.at + ahead)
    }

    fn peek(&self) -> Option<&'a Tok> {
        self.nth(0)
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

    /// Passes over a symbol if it is there.
    fn eat(&mut self, sym: Sym) -> bool {
        let found = self.is(sym);
        if found {
            self.bump();
        }
        found
    }

    /// Whether the declaration is through.
    fn at_border(&self) -> bool {
        self.layout.is_border(self.at)
    }

    /// Counts a step of a loop. False when there have been too many; then everything left is skipped.
    fn tick(&mut self) -> bool {
        if self.fuel == 1 {
            let span = self.span();
            self.diags.report(Code::TooDeep, span, "this cannot be read in reasonable time");
            self.at = self.layout.len();
        }
        self.fuel = self.fuel.saturating_sub(1);
        0 < self.fuel
    }

    /// The span of the token at a position, or of the last one.
    fn span_at(&self, at: usize) -> Span {
        match self.layout.index(at).or_else(|| self.layout.index(self.layout.len().checked_sub(1)?)) {
            Some(index) => Span::one(index),
            None => Span::default(),
        }
    }

    fn span(&self) -> Span {
        self.span_at(self.at)
    }

    /// From a position to the token before the next one.
    fn span_from(&self, start: usize) -> Span {
        self.span_at(start).to(self.span_at(self.at.saturating_sub(1).max(start)))
    }

    /// The next token as a name, and passes over it.
    fn take_name(&mut self) -> Option<Name> {
        let text = match self.peek()? {
            Tok::Ident(text) | Tok::Path(text) => text.clone(),
            _ => return None,
        };
        let span = self.span();
        self.bump();
        Some(Name { text, span })
    }

    /// The next tokens up to a position as a name with dots.
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

    /// The position of the bracket that closes the one here; reports it when there is none.
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
        // Where something could not be read, the bracket may be part of it.
        let list = if self.layout.bad_until_border(self.at) { &mut self.muted } else { &mut self.diags };
        let diag = list.report(Code::UnclosedBracket, span, format!("this {open} is never closed"));
        diag.help(format!("write `{close}` where it should end"));
        Err(Reported)
    }

    /// Runs a part that may contain itself.
    fn nested<T>(&mut self, part: impl FnOnce(&mut Self) -> Parsed<T>) -> Parsed<T> {
        if MAX_DEPTH <= self.depth {
            return self.too_deep();
        }
        self.depth += 1;
        let result = part(self);
        self.depth -= 1;
        result
    }

    /// Runs a part in brackets of its own, so that a comma in it means nothing outside.
    fn bracketed<T>(&mut self, comma_ends: bool, part: impl FnOnce(&mut Self) -> Parsed<T>) -> Parsed<T> {
        let outside = std::mem::replace(&mut self.comma_ends, comma_ends);
        let result = self.nested(part);
        self.comma_ends = outside;
        result
    }

    /// Runs a part and hands over what it has found, for whoever can say it better.
    fn tried<T>(&mut self, part: impl FnOnce(&mut Self) -> T) -> (T, Vec<Diag>) {
        let before = std::mem::take(&mut self.diags);
        let result = part(self);
        let found = std::mem::replace(&mut self.diags, before).finish();
        (result, found)
    }

    /// Reads what stands between `|` in the braces here, one call of `item` each, and passes over the closing brace.
    /// An item that fails is left out. `form` is what an item looks like, where there has to be one.
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
                    self.syntax(self.at, "`|` stands between the parts").help("write `|` for `,`");
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

    /// Nothing stands here, before a `|` or the end of the braces.
    fn missing_part(&mut self, form: &str, close: usize) {
        let before = self.at - 1;
        if self.at == close && self.layout.at(before).is_some_and(|token| token.is(Sym::LBrace)) {
            let span = self.span_at(before).to(self.span());
            let list = if self.layout.beside_bad(close) { &mut self.muted } else { &mut self.diags };
            let diag = list.report(Code::EmptyGroup, span, "nothing stands in these braces");
            diag.help(format!("write `{form}` in them"));
            return;
        }
        let (at, side) = if self.at == close { (before, "behind") } else { (self.at, "before") };
        let diag = self.syntax(at, format!("nothing stands {side} this `|`"));
        diag.help(format!("leave out the `|`, or write `{form}` {side} it"));
    }

    /// Skips to the end of what stands between `|`.
    fn skip_to_bar(&mut self, close: usize) {
        while self.at < close && !self.is(Sym::Bar) {
            self.at = self.layout.close(self.at).unwrap_or(self.at) + 1;
        }
    }
}
