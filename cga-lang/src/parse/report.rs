//! Findings of the parser: what was expected, what stands there, what to type.

use super::{MAX_DEPTH, Parsed, Parser, Reported};
use crate::code::Code;
use crate::diag::Diag;
use crate::lex::{NO_UNITS, without_unit};
use crate::span::Span;
use crate::token::{Sym, Tok};

/// What a rule's body consists of.
pub(super) const STEP: &str = "an operation or a rule";

impl Parser<'_> {
    /// Reports a mistake at a position; not where the door has found something unreadable right beside it.
    pub(super) fn syntax(&mut self, at: usize, message: impl Into<String>) -> &mut Diag {
        let span = self.span_at(at);
        self.syntax_over(at, span, message)
    }

    /// The same with more to underline.
    pub(super) fn syntax_over(&mut self, at: usize, span: Span, message: impl Into<String>) -> &mut Diag {
        let list = if self.layout.beside_bad(at) { &mut self.muted } else { &mut self.diags };
        list.report(Code::Syntax, span, message)
    }

    /// Reports that something else was expected here, with what is usually meant.
    pub(super) fn expected(&mut self, what: &str) -> &mut Diag {
        if let Some(value) = self.number_with_unit() {
            return self.expected_only(what).note(NO_UNITS).help(format!("write `{value}`"));
        }
        let help = match self.peek() {
            _ if self.at_border() => None,
            Some(Tok::Sym(Sym::Assign)) if self.nth_is(1, Sym::Greater) => Some("write `>=`"),
            Some(Tok::Sym(Sym::Assign)) => Some("two values are compared with `==`"),
            Some(Tok::Sym(Sym::Tilde | Sym::Quote) | Tok::Number(_)) if what == STEP => {
                Some("put `|` between the slots of a split")
            }
            Some(Tok::Sym(Sym::Colon)) if what == STEP => Some("put `|` between the parts of a split or comp"),
            Some(Tok::Sym(Sym::Quote)) => {
                Some("`'` and `^` stand before a relative size; a power is `pow(base, exponent)`")
            }
            Some(Tok::Sym(Sym::Star))
                if self
                    .at
                    .checked_sub(1)
                    .and_then(|at| self.layout.at(at))
                    .is_some_and(|token| token.is(Sym::Star)) =>
            {
                Some("a power is `pow(base, exponent)`")
            }
            Some(Tok::Sym(Sym::Star)) if what == STEP => Some("`*` stands behind the `}` of what it repeats"),
            _ => None,
        };
        let diag = self.expected_only(what);
        match help {
            Some(help) => diag.help(help),
            None => diag,
        }
    }

    /// What the number right before is without the unit that stands here.
    fn number_with_unit(&self) -> Option<f64> {
        let unit = self.peek().and_then(Tok::ident).filter(|_| !self.at_border())?;
        match self.layout.at(self.at.checked_sub(1)?)? {
            Tok::Number(value) => without_unit(*value, unit),
            _ => None,
        }
    }

    /// Reports that something else was expected here.
    pub(super) fn expected_only(&mut self, what: &str) -> &mut Diag {
        if self.at_border() && 0 < self.at {
            let tail = if self.layout.len() <= self.at { "the end" } else { "the next declaration" };
            return self.syntax(self.at - 1, format!("expected {what} after this, found {tail}"));
        }
        let found = self.peek().map_or("nothing".into(), Tok::describe);
        self.syntax(self.at, format!("expected {what}, found {found}"))
    }

    pub(super) fn fail<T>(&mut self, what: &str) -> Parsed<T> {
        self.expected(what);
        Err(Reported)
    }

    /// Passes over a symbol that has to be there.
    pub(super) fn expect(&mut self, sym: Sym) -> Parsed<()> {
        if self.eat(sym) { Ok(()) } else { self.fail(&format!("`{}`", sym.text())) }
    }

    /// Something stands behind a declaration that does not belong to it.
    pub(super) fn leftover(&mut self) {
        let found = self.peek().map_or("nothing".into(), Tok::describe);
        match self.peek() {
            Some(token) if token.ident() == Some("else") => {
                self.syntax(self.at, "`else` without a `case` or percentage before it")
            }
            Some(Tok::Sym(Sym::RParen | Sym::RBrace | Sym::RBracket)) => {
                self.syntax(self.at, format!("this {found} closes nothing"))
            }
            Some(Tok::Sym(Sym::Semi)) => self
                .syntax(self.at, "nothing ends a declaration")
                .help("leave out the `;`: the next one begins by itself"),
            _ => self.syntax(self.at, format!("unexpected {found}")),
        };
    }

    pub(super) fn too_deep<T>(&mut self) -> Parsed<T> {
        if !self.deep {
            self.deep = true;
            let span = self.span();
            self.diags
                .report(Code::TooDeep, span, format!("nested more than {MAX_DEPTH} deep"))
                .help("move a part into a rule or function of its own");
        }
        Err(Reported)
    }
}
