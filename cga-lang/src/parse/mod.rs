//! Tokens to tree. Never fails, never panics, always ends.
//!
//! A function that met something wrong reports it and returns `Err(Reported)`; nobody reports it again. The nearest
//! slot or arm, else the declaration, goes on behind it: a mistake in one rule does not hide those of another.

mod annotation;
mod branch;
mod comp;
mod expr;
mod item;
mod layout;
mod op;
mod split;

use crate::ast::{Ast, Name};
use crate::code::Code;
use crate::diag::{Diag, Diags};
use crate::span::Span;
use crate::token::{Sym, Tok, Tokens};
use layout::Layout;

/// Deepest nesting of brackets and branches, and deepest expression.
pub const MAX_DEPTH: u32 = 200;

/// Builds the tree; what is wrong goes to `diags`.
pub fn parse(tokens: &Tokens, diags: &mut Diags) -> Ast {
    let mut parser = Parser::new(tokens.as_slice());
    let ast = parser.grammar();
    diags.append(parser.diags.finish());
    ast
}

/// Something was wrong and has been reported.
struct Reported;

/// What a rule's body consists of.
const STEP: &str = "an operation or a rule";

type Parsed<T> = Result<T, Reported>;

struct Parser<'a> {
    /// Every token; spans count these.
    tokens: &'a [Tok],
    /// Those that count, as indices. Positions count these.
    view: Vec<u32>,
    /// Doc comments, by the position they stand before.
    docs: Vec<(usize, &'a str)>,
    layout: Layout,
    at: usize,
    depth: u32,
    /// Whether `TooDeep` was reported in this declaration.
    deep: bool,
    /// Steps left before the parser gives up: a guard against a loop that makes no progress.
    fuel: usize,
    lost: Vec<String>,
    diags: Diags,
}

impl<'a> Parser<'a> {
    fn new(tokens: &'a [Tok]) -> Self {
        let mut view = Vec::with_capacity(tokens.len());
        let mut docs = Vec::new();
        for (index, token) in tokens.iter().enumerate() {
            match token {
                Tok::Bad => {}
                Tok::Doc(text) => docs.push((view.len(), text.as_str())),
                _ => view.push(index as u32),
            }
        }
        let layout = Layout::new(tokens, &view);
        let fuel = tokens.len() * 16 + 1000;
        Parser { tokens, view, docs, layout, at: 0, depth: 0, deep: false, fuel, lost: Vec::new(), diags: Diags::new() }
    }

    /// The token `ahead` of the next one.
    fn nth(&self, ahead: usize) -> Option<&'a Tok> {
        self.view.get(self.at + ahead).map(|&index| &self.tokens[index as usize])
    }

    fn peek(&self) -> Option<&'a Tok> {
        self.nth(0)
    }

    fn is(&self, sym: Sym) -> bool {
        self.peek().is_some_and(|token| token.is(sym))
    }

    fn nth_is(&self, ahead: usize, sym: Sym) -> bool {
        self.nth(ahead).is_some_and(|token| token.is(sym))
    }

    fn is_word(&self, word: &str) -> bool {
        self.peek().and_then(Tok::ident) == Some(word)
    }

    fn bump(&mut self) {
        self.at = (self.at + 1).min(self.view.len());
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
        self.view.len() <= self.at || self.layout.starts[self.at]
    }

    /// Counts a step of a loop. False when there have been too many; then everything left is skipped.
    fn tick(&mut self) -> bool {
        self.fuel = self.fuel.saturating_sub(1);
        if self.fuel == 0 {
            self.at = self.view.len();
        }
        0 < self.fuel
    }

    /// The span of the token at a position, or of the last one.
    fn span_at(&self, at: usize) -> Span {
        match self.view.get(at).or(self.view.last()) {
            Some(&index) => Span::one(index),
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

    /// Reports that something else was expected here.
    fn expected(&mut self, what: &str) -> &mut Diag {
        if self.at_border() && 0 < self.at {
            let span = self.span_at(self.at - 1);
            let tail = if self.view.len() <= self.at { "the end" } else { "the next declaration" };
            return self.diags.report(Code::Syntax, span, format!("expected {what} after this, found {tail}"));
        }
        let span = self.span();
        let found = self.peek().map_or("nothing".into(), Tok::describe);
        let help = match self.peek() {
            Some(Tok::Sym(Sym::Assign)) => Some("two values are compared with `==`"),
            Some(Tok::Sym(Sym::Tilde | Sym::Quote) | Tok::Number(_)) if what == STEP => {
                Some("put `|` between the slots of a split")
            }
            Some(Tok::Sym(Sym::Star)) if what == STEP => Some("`*` stands behind the `}` of what it repeats"),
            _ => None,
        };
        let diag = self.diags.report(Code::Syntax, span, format!("expected {what}, found {found}"));
        match help {
            Some(help) => diag.help(help),
            None => diag,
        }
    }

    fn fail<T>(&mut self, what: &str) -> Parsed<T> {
        self.expected(what);
        Err(Reported)
    }

    fn expect(&mut self, sym: Sym) -> Parsed<()> {
        if self.eat(sym) { Ok(()) } else { self.fail(&format!("`{}`", sym.text())) }
    }

    fn unsupported(&mut self, span: Span, what: &str) -> &mut Diag {
        self.diags.report(Code::Unsupported, span, format!("{what} not supported yet"))
    }

    /// The position of the bracket that closes the one here; reports it when there is none.
    fn closing(&mut self) -> Parsed<usize> {
        if let Some(close) = self.layout.close(self.at) {
            return Ok(close);
        }
        let (span, open) = (self.span(), self.peek().map_or("bracket".into(), Tok::describe));
        self.diags.report(Code::UnclosedBracket, span, format!("this {open} is never closed"));
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

    fn too_deep<T>(&mut self) -> Parsed<T> {
        if !self.deep {
            self.deep = true;
            let span = self.span();
            self.diags
                .report(Code::TooDeep, span, format!("nested more than {MAX_DEPTH} deep"))
                .help("move a part into a rule or function of its own");
        }
        Err(Reported)
    }

    /// Reads what stands between `|` in the braces here, one call of `item` each, and passes over the closing brace.
    /// An item that fails is left out.
    fn between_bars<T>(&mut self, mut item: impl FnMut(&mut Self) -> Parsed<T>) -> Parsed<Vec<T>> {
        let close = self.closing()?;
        self.bump();
        let mut items = Vec::new();
        while self.tick() {
            if let Ok(one) = self.nested(&mut item) {
                items.push(one);
                if self.at < close && !self.is(Sym::Bar) {
                    self.expected("`|` or `}`");
                }
            }
            while self.at < close && !self.is(Sym::Bar) {
                self.at = self.layout.close(self.at).unwrap_or(self.at) + 1;
            }
            if close <= self.at {
                break;
            }
            self.bump();
        }
        self.at = close + 1;
        Ok(items)
    }
}
